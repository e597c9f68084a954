import { dot, length, normalize, scale, subtract } from "../math/vec3";
import type { Light, Rgb, Vec3 } from "../scene/schema";
import { spotCone, spotFalloff } from "../scene/spotCone";

/** What arrives from a light at a point, without shadows. */
export type Arriving = {
  /** On a surface that faces it, W·m⁻². */
  readonly irradiance: Rgb;
  /** Towards the light, unit. */
  readonly way: Vec3;
};

export function lightAt(light: Light, point: Vec3): Arriving {
  if ("irradiance" in light) {
    return { irradiance: light.irradiance, way: normalize(scale(light.direction, -1)) };
  }
  const toLight = subtract(light.position, point);
  const distance = length(toLight);
  const way = scale(toLight, 1 / distance);
  if (!("direction" in light)) return { irradiance: scale(light.power, 1 / (4 * Math.PI * distance ** 2)), way };
  const cone = spotCone(light);
  const falloff = spotFalloff(cone, -dot(way, normalize(light.direction)));
  return { irradiance: scale(cone.intensity, falloff / distance ** 2), way };
}
