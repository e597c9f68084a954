// The layout of `scene`, the buffer that holds a scene's values: its text and its bytes from one list of members.

import { defineStruct, type StructFields, type StructLayout, type StructValue } from "./defineStruct";
import { LIGHT, UNBOUNDED } from "./layouts";
import type { Tables } from "./packScene";
import type { Unrolling } from "./unrolling";

/** A member of the struct `Scene`: an array of a WGSL type, of at least one element, because WGSL has no empty ones. */
export type Member = {
  readonly name: string;
  readonly type: string;
  readonly count: number;
  /** A multiple of 16 long. */
  readonly bytes: ArrayBuffer;
};

/** All but the slots, which come last. */
export function sceneMembers(tables: Tables, { loops }: Unrolling): Member[] {
  const { lightBounds, lightFronts, primitiveBounds, ofTextures } = tables;
  return [
    vec4s("environment", [[...tables.environment, 0]]),
    structs("materials", "Material", tables.materials.layout, tables.materials.rows),
    // By primitive: see `ShapeKind`.
    vec4s("shapes", tables.shapes),
    vec4s("anchors", tables.anchors),
    structs("lights", "Light", LIGHT, tables.lights),
    // Of many lights, by light: the ball around it; the side it shines to, or zero, and its strength. By primitive: the ball around
    // its lights.
    ...(lightBounds.length > 0
      ? [
          vec4s("lightBounds", lightBounds),
          vec4s("lightFronts", lightFronts),
          vec4s("primitiveBounds", primitiveBounds),
        ]
      : []),
    ...loops.map(({ table: { table } }, i) => structs(table, "Unbounded", UNBOUNDED, tables.unbounded[i]!)),
    ...(ofTextures
      ? [
          structs<StructFields>("factors", "Factors", ofTextures.factorsLayout, ofTextures.factors),
          structs<StructFields>("textures", "Texture", ofTextures.layout, ofTextures.textures),
        ]
      : []),
  ];
}

/** Values of the generated functions: four numbers each. */
export function slotsMember(numbers: readonly number[]): Member {
  return member("slots", "vec4f", numbers.length / 4, new Float32Array(numbers).buffer, VEC4.bytes);
}

/** The text of the struct `Scene`. */
export function emitMembers(members: readonly Member[]): string {
  return `struct Scene {\n${members.map(({ name, type, count }) => `  ${name}: array<${type}, ${count}>,\n`).join("")}}\n`;
}

/** The bytes of all members, one after the other. */
export function packMembers(members: readonly Member[]): ArrayBuffer {
  const all = new Uint8Array(bytesOf(members));
  let offset = 0;
  for (const { bytes } of members) {
    all.set(new Uint8Array(bytes), offset);
    offset += bytes.byteLength;
  }
  return all.buffer;
}

/** Of all members together. */
export function bytesOf(members: readonly Member[]): number {
  return members.reduce((sum, { bytes }) => sum + bytes.byteLength, 0);
}

const VEC4 = defineStruct({ value: "vec4f" });

function member(name: string, type: string, count: number, bytes: ArrayBuffer, stride: number): Member {
  return count > 0 ? { name, type, count, bytes } : { name, type, count: 1, bytes: new ArrayBuffer(stride) };
}

function vec4s(name: string, values: readonly (readonly number[])[]): Member {
  const floats = new Float32Array(4 * values.length);
  for (const [i, value] of values.entries()) floats.set(value, 4 * i);
  return member(name, "vec4f", values.length, floats.buffer, VEC4.bytes);
}

function structs<F extends StructFields>(
  name: string,
  type: string,
  layout: StructLayout<F>,
  values: readonly StructValue<F>[],
): Member {
  const buffer = new ArrayBuffer(layout.bytes * values.length);
  const [view, bytes] = [new DataView(buffer), new Uint8Array(buffer)];
  // Many primitives may have one row: copying is ten times quicker than writing.
  const written = new Map<StructValue<F>, number>();
  for (const [i, value] of values.entries()) {
    const [at, from] = [i * layout.bytes, written.get(value)];
    if (from === undefined) {
      layout.write(view, at, value);
      written.set(value, at);
    } else bytes.copyWithin(at, from, from + layout.bytes);
  }
  return member(name, type, values.length, buffer, layout.bytes);
}
