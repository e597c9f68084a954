import { dielectricF0 } from "../scene/metals";
import type { ResolvedMaterial, Rgb } from "../scene/schema";
import type { StructFields, StructLayout, StructValue } from "./defineStruct";
import { hasManyLights } from "./emitLights";
import { type Emitter, LIGHT_KINDS } from "./emitters";
import { alphaOf, hasHugeSpheres, hasRims, hasSpecularLobe } from "./features";
import type { Geometry } from "./geometry";
import { FACTORS, LIGHT, MATERIAL, TEXTURE } from "./layouts";
import { factorRows, hasTextures, type Textures, textureRows } from "./packTextures";
import type { Primitive, Shape } from "./primitives";
import { towardsMiddle } from "./rims";
import { add, cross, length, scale, subtract } from "./vec3";

const NO_PRIMITIVE = 0xffffffff;
const VEC4_BYTES = 16;

/**
 * The bytes of `scene`: environment, materials, shapes, anchors, lights, their bounds, factors, textures, slots, in the order and with the array
 * lengths of the struct that `emitScene` declares. Every member is a multiple of 16 bytes long.
 */
export function packScene(
  primitives: readonly Primitive[],
  emitters: readonly Emitter[],
  geometry: Geometry | undefined,
  environment: Rgb,
  textures: Textures,
  slots: readonly number[],
): ArrayBuffer {
  const materials = materialRows(primitives, emitters);
  const shapes = primitives.flatMap(({ shape }) => shapeRow(shape));
  return concatenate([
    floats([...environment, 0]),
    orZeros(rows(MATERIAL, materials), MATERIAL.bytes),
    orZeros(floats(shapes), VEC4_BYTES),
    orZeros(floats(anchorRows(primitives).flat()), VEC4_BYTES),
    orZeros(rows(LIGHT, lightRows(primitives, emitters, geometry)), LIGHT.bytes),
    floats(hasManyLights(emitters) ? lightBoundRows(primitives, emitters).flat() : []),
    rows(FACTORS, hasTextures(textures) ? factorRows(primitives, textures) : []),
    rows(TEXTURE, textureRows(textures)),
    orZeros(floats(slots), VEC4_BYTES),
  ]);
}

/** The surfaces of all primitives, by id. */
export function materialRows(primitives: readonly Primitive[], emitters: readonly Emitter[]) {
  return primitives.map((primitive, id) => materialRow(primitive, id, emitters));
}

function materialRow({ shape, material, emission }: Primitive, id: number, emitters: readonly Emitter[]) {
  return { ...reflectance(material), emission, lightDensity: lightDensity(shape, id, emitters) };
}

/** See `Material` in `wgsl/surface.wgsl`. */
function lightDensity(shape: Shape, id: number, emitters: readonly Emitter[]): number {
  const own = emitters.filter((emitter) => emitter.primitive === id);
  if (own.length === 0) return 0;
  const weight = emitters.length > 1 ? own.reduce((sum, { strength }) => sum + strength, 0) : 1;
  return shape.kind === "sphere" ? weight : weight / own.reduce((sum, { size }) => sum + size, 0);
}

function reflectance(material: ResolvedMaterial | "black") {
  if (material === "black") return BLACK;
  const { baseColor, metallic, ior, masking, multiscatter } = material;
  const schlickBeckmann = masking === "schlick-beckmann" ? 1 : 0;
  if (!hasSpecularLobe(material)) return { ...BLACK, diffuse: baseColor };
  const f0 = dielectricF0(ior);
  return {
    F0: add(scale([f0, f0, f0], 1 - metallic), scale(baseColor, metallic)),
    alpha: alphaOf(material),
    diffuse: scale(baseColor, 1 - metallic),
    f0,
    f90: 1,
    schlickBeckmann,
    multiscatter: multiscatter ? metallic : 0,
  };
}

const BLACK = {
  F0: [0, 0, 0],
  alpha: 1,
  diffuse: [0, 0, 0] as Rgb,
  f0: 0,
  f90: 0,
  schlickBeckmann: 0,
  multiscatter: 0,
};

/** Centre and radius of a sphere, unit normal and 0 of a flat shape, -1 last for a box. */
export function shapeRow(shape: Shape): number[] {
  switch (shape.kind) {
    case "sphere":
      return [...shape.center, shape.radius];
    case "box":
    case "mesh":
      return [0, 0, 0, -1]; // the normal depends on the point: shapeNormal(), meshPoint()
    default:
      return [...shape.normal, 0];
  }
}

/** One per primitive, or none where the shader reads none: see features. */
export function anchorRows(primitives: readonly Primitive[]): number[][] {
  const isRead = hasRims(primitives) || hasHugeSpheres(primitives);
  return isRead ? primitives.map(({ shape }) => anchorRow(shape)) : [];
}

/**
 * A point on a flat shape, its middle if it has one, and the factor by which points on it are drawn there; the foot of a huge
 * sphere and 1; else zeros.
 */
function anchorRow(shape: Shape): number[] {
  switch (shape.kind) {
    case "plane":
      return [...shape.point, 1];
    case "quad": {
      const { corner, edge1, edge2 } = shape;
      const middle = add(corner, scale(add(edge1, edge2), 0.5));
      const sides = [length(edge1), length(edge2)];
      const toEdge = length(cross(edge1, edge2)) / (2 * Math.max(...sides));
      return [...middle, towardsMiddle(middle, toEdge, (sides[0]! + sides[1]!) / 2)];
    }
    case "triangle": {
      const [a, b, c] = shape.vertices;
      const middle = scale(add(a, add(b, c)), 1 / 3);
      const sides = [subtract(b, a), subtract(c, b), subtract(a, c)];
      const longest = Math.max(...sides.map(length));
      const toEdge = length(cross(sides[0]!, sides[1]!)) / (3 * longest);
      return [...middle, towardsMiddle(middle, toEdge, longest)];
    }
    case "sphere":
      return shape.foot ? [...shape.foot, 1] : [0, 0, 0, 0];
    case "box":
    case "mesh":
      return [0, 0, 0, 0];
  }
}

/** The emitters, as the shader's table wants them. */
export function lightRows(
  primitives: readonly Primitive[],
  emitters: readonly Emitter[],
  geometry: Geometry | undefined,
) {
  return emitters.map((emitter) => ({
    ...emitter,
    kind: LIGHT_KINDS[emitter.kind],
    id: emitter.kind === "mesh" ? NO_PRIMITIVE : hitId(emitter.primitive, primitives.length, geometry),
  }));
}

/** What a ray that hits a primitive names. */
function hitId(id: number | undefined, primitiveCount: number, geometry: Geometry | undefined): number {
  if (id === undefined) return NO_PRIMITIVE;
  const slot = geometry?.shapes.get(id);
  return slot === undefined ? id : primitiveCount + slot;
}

/** Bounds and fronts of lights, and bounds of primitives, where the shader looks them up: see `emitScene`. */
function lightBoundRows(primitives: readonly Primitive[], emitters: readonly Emitter[]): number[][] {
  const byPrimitive = new Map(emitters.map(({ primitive, bound }) => [primitive, bound]));
  const row = (bound: Emitter["bound"] | undefined) => (bound ? [...bound.center, bound.radius] : [0, 0, 0, 0]);
  return [
    ...emitters.map(({ bound }) => row(bound)),
    ...emitters.map(({ front = [0, 0, 0], strength }) => [...front, strength]),
    ...primitives.map((_, id) => row(byPrimitive.get(id))),
  ];
}

function rows<F extends StructFields>(layout: StructLayout<F>, values: readonly StructValue<F>[]): ArrayBuffer {
  const view = new DataView(new ArrayBuffer(layout.bytes * values.length));
  for (const [i, value] of values.entries()) layout.write(view, i * layout.bytes, value);
  return view.buffer as ArrayBuffer;
}

function floats(numbers: readonly number[]): ArrayBuffer {
  return new Float32Array(numbers).buffer;
}

/** WGSL has no empty arrays: where there is nothing, one element that is never read. */
function orZeros(array: ArrayBuffer, elementBytes: number): ArrayBuffer {
  return array.byteLength > 0 ? array : new ArrayBuffer(elementBytes);
}

function concatenate(parts: readonly ArrayBuffer[]): ArrayBuffer {
  const all = new Uint8Array(parts.reduce((bytes, part) => bytes + part.byteLength, 0));
  let offset = 0;
  for (const part of parts) {
    all.set(new Uint8Array(part), offset);
    offset += part.byteLength;
  }
  return all.buffer;
}
