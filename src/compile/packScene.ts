import type { Ball, Light } from "../lights/light";
import { samplerOf, tagOf } from "../lights/lights";
import { reflectance } from "../lobes/lobes";
import type { Rgb } from "../scene/schema";
import type { Vec4 } from "../shapes/shape";
import { kindOf } from "../shapes/shapes";
import type { Geometry } from "../tree/geometry";
import type { Textures } from "../tree/packTexels";
import type { StructFields, StructLayout, StructValue } from "./defineStruct";
import { hasManyLights } from "./emitLights";
import { unboundedRows } from "./emitLoops";
import { hasHugeBalls, hasRims } from "./features";
import { FACTORS, LIGHT, MATERIAL, TEXTURE, UNBOUNDED } from "./layouts";
import { factorRows, hasTextures, textureRows } from "./packTextures";
import type { Primitive } from "./primitives";
import type { Unrolling } from "./unrolling";

const NO_PRIMITIVE = 0xffffffff;
const VEC4_BYTES = 16;

/** What the shader looks up by number, and the environment; see the struct that `emitScene` declares. */
export type Tables = ReturnType<typeof tablesOf>;

export function tablesOf(
  primitives: readonly Primitive[],
  lights: readonly Light[],
  unrolling: Unrolling,
  geometry: Geometry | undefined,
  environment: Rgb,
  textures: Textures,
) {
  const isMany = hasManyLights(lights);
  return {
    environment,
    materials: materialRows(primitives, lights),
    shapes: primitives.map(({ shape }) => kindOf(shape).row(shape)),
    anchors: anchorRows(primitives),
    lights: lightRows(primitives, lights, geometry),
    lightBounds: isMany ? lightBoundRows(primitives, lights) : [],
    unbounded: unboundedRows(unrolling, primitives),
    factors: hasTextures(textures) ? factorRows(primitives, textures) : [],
    textures: textureRows(textures),
  };
}

/**
 * The bytes of `scene`, its members one by one, but for the slots, which come last: in the order and with the array lengths of
 * the struct that `emitScene` declares. Every member is a multiple of 16 bytes long.
 */
export function packTables(tables: Tables): ArrayBuffer[] {
  return [
    new Float32Array([...tables.environment, 0]).buffer,
    orZeros(rows(MATERIAL, tables.materials), MATERIAL.bytes),
    orZeros(vec4s(tables.shapes), VEC4_BYTES),
    orZeros(vec4s(tables.anchors), VEC4_BYTES),
    orZeros(rows(LIGHT, tables.lights), LIGHT.bytes),
    vec4s(tables.lightBounds),
    rows(UNBOUNDED, tables.unbounded),
    rows(FACTORS, tables.factors),
    rows(TEXTURE, tables.textures),
  ];
}

/** The bytes of `scene`: those of its tables, then the slots. */
export function packScene(tables: readonly ArrayBuffer[], slots: readonly number[]): ArrayBuffer {
  const members = [...tables, orZeros(new Float32Array(slots).buffer, VEC4_BYTES)];
  const all = new Uint8Array(bytesOf(members));
  let offset = 0;
  for (const member of members) {
    all.set(new Uint8Array(member), offset);
    offset += member.byteLength;
  }
  return all.buffer;
}

/** Of all members together. */
export function bytesOf(members: readonly ArrayBuffer[]): number {
  return members.reduce((bytes, member) => bytes + member.byteLength, 0);
}

/** The surfaces of all primitives, by id. Those of a material that are no lights share a row. */
function materialRows(primitives: readonly Primitive[], lights: readonly Light[]) {
  const densities = lightDensities(lights);
  const dark = new Map<Primitive["material"], ReturnType<typeof materialRow>>();
  return primitives.map((primitive, id) => {
    const density = densities.get(id);
    if (density !== undefined) return materialRow(primitive, density);
    const row = dark.get(primitive.material) ?? materialRow(primitive, 0);
    dark.set(primitive.material, row);
    return row;
  });
}

function materialRow({ material, emission }: Primitive, lightDensity: number) {
  return { ...reflectance(material), emission, lightDensity };
}

/** By primitive that emits; see `Material` in `wgsl/surface.wgsl`. */
function lightDensities(lights: readonly Light[]): ReadonlyMap<number, number> {
  const sums = new Map<number, { weight: number; size: number; isCone: boolean }>();
  for (const light of lights) {
    const { primitive, strength, size } = light;
    if (primitive === undefined) continue;
    const sum = sums.get(primitive) ?? { weight: 0, size: 0 };
    const isCone = samplerOf(light).measure === "cone";
    sums.set(primitive, { weight: sum.weight + strength, size: sum.size + size, isCone });
  }
  const isAlone = lights.length === 1;
  return new Map(
    Array.from(sums, ([id, { weight, size, isCone }]) => {
      const share = isAlone ? 1 : weight;
      return [id, isCone ? share : share / size];
    }),
  );
}

/** One per primitive, or none where the shader reads none: see features. */
function anchorRows(primitives: readonly Primitive[]): readonly Vec4[] {
  const isRead = hasRims(primitives) || hasHugeBalls(primitives);
  return isRead ? primitives.map(({ shape }) => kindOf(shape).anchor(shape)) : [];
}

/** The lights, as the shader's table wants them. */
function lightRows(primitives: readonly Primitive[], lights: readonly Light[], geometry: Geometry | undefined) {
  return lights.map((light) => {
    const { position, size, edge1, edge2, normal, radiance } = light;
    const id = hitId(light.primitive, primitives, geometry);
    return { position, size, edge1, edge2, normal, radiance, kind: tagOf(light), id };
  });
}

/** What a ray that hits a primitive names; of a mesh it names the triangle. */
function hitId(id: number | undefined, primitives: readonly Primitive[], geometry: Geometry | undefined): number {
  if (id === undefined || kindOf(primitives[id]!.shape).triangleDistance) return NO_PRIMITIVE;
  const slot = geometry?.shapes.get(id);
  return slot === undefined ? id : primitives.length + slot;
}

/** Bounds and fronts of lights, and bounds of primitives, where the shader looks them up: see `emitScene`. */
function lightBoundRows(primitives: readonly Primitive[], lights: readonly Light[]): number[][] {
  const byPrimitive = new Map(lights.map(({ primitive, bound }) => [primitive, bound]));
  const row = (bound: Ball | undefined) => (bound ? [...bound.center, bound.radius] : [0, 0, 0, 0]);
  return [
    ...lights.map(({ bound }) => row(bound)),
    ...lights.map(({ front = [0, 0, 0], strength }) => [...front, strength]),
    ...primitives.map((_, id) => row(byPrimitive.get(id))),
  ];
}

function rows<F extends StructFields>(layout: StructLayout<F>, values: readonly StructValue<F>[]): ArrayBuffer {
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
  return buffer;
}

function vec4s(values: readonly (readonly number[])[]): ArrayBuffer {
  const floats = new Float32Array(4 * values.length);
  for (const [i, value] of values.entries()) floats.set(value, 4 * i);
  return floats.buffer;
}

/** WGSL has no empty arrays: where there is nothing, one element that is never read. */
function orZeros(array: ArrayBuffer, elementBytes: number): ArrayBuffer {
  return array.byteLength > 0 ? array : new ArrayBuffer(elementBytes);
}
