// Whether a file brings enough light of its own.

import { dot, subtract } from "../math/vec3";
import { type Mesh, meshesAmong } from "../scene/meshes";
import type { Light, Material, Rgb, Scene, Texture, Vec3 } from "../scene/schema";
import { emissionOf } from "../scene/shown";
import { uvRows, wholeReference } from "../scene/textureReference";
import { extentOf, twiceAreaAt } from "./bounds";
import { firstSight, pointOf, type SeenPoint, type Uv } from "./firstSight";
import { IRRADIANCE } from "./frameModel";
import { lightAt } from "./lightAt";

/** W·m⁻²: five stops less than the table gives. A white surface shows as 36 of 255 with it. */
const ENOUGH = IRRADIANCE / 32;
/** Of what is in view: a lamp from the side lights half of a ball, one on its surface less than a fifth. */
const MIN_SHARE = 0.25;
/** Points that stand for all that emits. */
const EMITTER_POINTS = 256;

/** A part of a surface that emits. */
type Emitter = {
  readonly point: Vec3;
  readonly normal: Vec3;
  readonly area: number;
  readonly radiance: Rgb;
  readonly isDoubleSided: boolean;
};

/**
 * Whether the lights and the emitting surfaces of a scene light it enough to be seen, as its camera first sees it.
 *
 * That is so if a quarter of what is in view and does not emit gets a thirty-second of the irradiance that the table would give,
 * 0.11 W·m⁻² in the strongest of its colours, or if half of what is in view emits as much as a white surface would reflect then.
 * The irradiance is what arrives directly, without shadows. Of textures that emit, the texels count.
 */
export function isLit(scene: Scene): boolean {
  const { objects, materials = {}, lights = [], camera } = scene;
  const meshes = meshesAmong(objects);
  const emitters = emittersOf(meshes, scene);
  if (lights.length === 0 && emitters.length === 0) return false;
  const seen = firstSight(camera, meshes);
  const emits = ({ mesh, isFront, uvs }: SeenPoint) => {
    const material = materials[mesh.material]!;
    return (isFront || hasTwoSides(material)) && Math.max(...emissionAt(material, uvs, scene)) >= ENOUGH / Math.PI;
  };
  const dark = seen.filter((point) => !emits(point));
  if (dark.length <= seen.length / 2) return true;
  const lit = dark.filter((point) => Math.max(...irradianceAt(point, lights, emitters)) >= ENOUGH);
  return lit.length >= MIN_SHARE * dark.length;
}

function irradianceAt({ point, normal }: SeenPoint, lights: readonly Light[], emitters: readonly Emitter[]): Rgb {
  const sum: [number, number, number] = [0, 0, 0];
  const addLight = (color: Rgb, factor: number) => {
    for (let channel = 0; channel < 3; channel++) sum[channel]! += color[channel]! * factor;
  };
  for (const light of lights) {
    const { irradiance, way } = lightAt(light, point);
    const cosine = dot(way, normal);
    if (cosine > 0) addLight(irradiance, cosine);
  }
  for (const { point: from, normal: front, area, radiance, isDoubleSided } of emitters) {
    const way = subtract(from, point);
    const squaredDistance = dot(way, way);
    const facing = isDoubleSided ? Math.abs(dot(way, front)) : -dot(way, front);
    const cosines = (Math.max(0, dot(way, normal)) * Math.max(0, facing)) / squaredDistance;
    // As of a disc, so that no part gives more than π times its radiance, however near it is.
    if (cosines > 0) addLight(radiance, (cosines * area) / (squaredDistance + area / Math.PI));
  }
  return sum;
}

/** Points spread evenly over what emits, by its power. */
function emittersOf(meshes: readonly Mesh[], scene: Scene): Emitter[] {
  const { materials = {} } = scene;
  const strengthOf = ({ material }: Mesh) => Math.max(...emissionOf(materials[material]!));
  const emitting = meshes.filter((mesh) => strengthOf(mesh) > 0);
  let total = 0;
  for (const mesh of emitting) total += extentOf(...dataOf(mesh)).area * strengthOf(mesh);
  const step = total / EMITTER_POINTS;
  const emitters: Emitter[] = [];
  let passed = 0;
  for (const mesh of emitting) {
    const strength = strengthOf(mesh);
    const [positions, indices] = dataOf(mesh);
    for (let i = 0; i < indices.length; i += 3) {
      passed += (twiceAreaAt(positions, indices, i) / 2) * strength;
      while (emitters.length < EMITTER_POINTS && passed > (emitters.length + 0.5) * step) {
        const { point, normal, uvs } = pointOf(mesh, i, spreadWeights(emitters.length));
        const radiance = emissionAt(materials[mesh.material]!, uvs, scene);
        const isDoubleSided = hasTwoSides(materials[mesh.material]!);
        emitters.push({ point, normal, area: step / strength, radiance, isDoubleSided });
      }
    }
  }
  return emitters;
}

/** What a loader makes. */
function dataOf({ positions, indices }: Mesh): [Float32Array | Float64Array, Uint32Array] {
  return [positions as Float32Array | Float64Array, indices as Uint32Array];
}

/** The nth point of a sequence that is even over a triangle (Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences"). */
function spreadWeights(n: number): Vec3 {
  const [u, v] = [(0.5 + n * 0.7548776662466927) % 1, (0.5 + n * 0.5698402909980532) % 1];
  const root = Math.sqrt(u);
  return [1 - root, root * (1 - v), root * v];
}

function hasTwoSides({ unlit = false, doubleSided = false }: Material): boolean {
  return unlit || doubleSided;
}

function emissionAt(material: Material, uvs: SeenPoint["uvs"], { textures = {} }: Scene): Rgb {
  const emission = emissionOf(material);
  const reference = wholeReference((material.unlit ? material.baseColorTexture : material.emissionTexture) ?? "");
  const [texture, uv] = [textures[reference.texture], uvs[reference.uv]];
  if (texture === undefined || uv === undefined) return emission;
  const [toU, toV] = uvRows(reference);
  const color = texelAt(texture, [dot(toU, [...uv, 1]), dot(toV, [...uv, 1])]);
  return [emission[0] * color[0], emission[1] * color[1], emission[2] * color[2]];
}

/** The colour of the texel at a point, linear. */
function texelAt({ width, height, texels, wrapU, wrapV }: Texture, [u, v]: Uv): Rgb {
  const column = Math.min(width - 1, Math.floor(wrap(u, wrapU) * width));
  const row = Math.min(height - 1, Math.floor(wrap(v, wrapV) * height));
  const at = 4 * (width * row + column);
  return [toLinear(texels[at]!), toLinear(texels[at + 1]!), toLinear(texels[at + 2]!)];
}

/** @returns from 0 to 1. */
function wrap(coordinate: number, how: Texture["wrapU"] = "repeat"): number {
  if (how === "clamp") return Math.min(1, Math.max(0, coordinate));
  if (how === "repeat") return coordinate - Math.floor(coordinate);
  const within = coordinate - 2 * Math.floor(coordinate / 2);
  return within > 1 ? 2 - within : within;
}

/** IEC 61966-2-1. */
function toLinear(byte: number): number {
  const value = byte / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}
