import { kindOfLight } from "../lights/lights";
import { length, scale, subtract } from "../math/vec3";
import type { ResolvedMaterial, ResolvedScene, Rgb, Vec3 } from "../scene/schema";
import { kindOfObject } from "./shapes";

// Scenes whose camera is between these powers of two from what it looks at keep the metre: products of three and four lengths
// near it are well within f32.
const METRE_STEPS = 16;

// As in scene/numbers.ts, in units: nothing is seen of what is smaller, and no ray goes farther.
const MAX_MAGNITUDE = 1e18;
const MIN_SIZE = 1e-18;

/** A scene in the shader's unit of length. */
export type SceneInUnits = {
  readonly scene: ResolvedScene;
  /** Metres. */
  readonly unit: number;
};

/**
 * Measures a scene in a power of two that brings the camera about 1 from what it looks at, if a metre is far from that: products
 * of lengths then stay within f32 for a scene of any size, and no digit changes. Radiances stay; powers go as length².
 */
export function inSceneUnits(scene: ResolvedScene): SceneInUnits {
  const { camera, materials, objects, lights } = scene;
  const steps = Math.round(Math.log2(length(subtract(camera.position, camera.target))));
  if (Math.abs(steps) <= METRE_STEPS) return { scene, unit: 1 };
  const unit = 2 ** steps;
  const point = (p: Vec3): Vec3 => [coordinate(p[0] / unit), coordinate(p[1] / unit), coordinate(p[2] / unit)];
  const power = (watts: Rgb) => scale(watts, unit ** -2);
  const size = (x: number) => Math.min(Math.max(x / unit, MIN_SIZE), MAX_MAGNITUDE);
  const measure = { point, size, coordinate: (x: number) => coordinate(x / unit), power };
  return {
    unit,
    scene: {
      ...scene,
      camera: { ...camera, position: point(camera.position), target: point(camera.target) },
      materials: Object.fromEntries(
        Object.entries(materials).map(([name, material]) => [name, inUnits(material, size)]),
      ),
      objects: objects.map((object) => kindOfObject(object).measure(object, measure)),
      lights: lights.map((light) => kindOfLight(light).measure(light, measure)),
    },
  };
}

function inUnits(material: ResolvedMaterial, size: (x: number) => number): ResolvedMaterial {
  const { attenuationDistance } = material;
  if (attenuationDistance === undefined) return material;
  return { ...material, attenuationDistance: size(attenuationDistance) };
}

function coordinate(x: number): number {
  return Math.min(Math.max(x, -MAX_MAGNITUDE), MAX_MAGNITUDE);
}
