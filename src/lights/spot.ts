import { normalize, subtract } from "../math/vec3";
import type { ResolvedLight } from "../scene/schema";
import { spotCone } from "../scene/spotCone";
import { type SceneLight, sum } from "./light";

/**
 * A lamp that shines into a cone. With a radius it is a disk across its axis, each part of which shines like the whole: its radiance is
 * intensity / (π·radius²·cos θ). Like a point, it has no body, and no ray hits it.
 */
export const spot: SceneLight<ResolvedLight & { type: "spot" }> = {
  measure: (light, { point, size, power }) => ({
    ...light,
    position: point(light.position),
    radius: light.radius > 0 ? size(light.radius) : 0,
    // Intensity goes as power does.
    ...(light.power && { power: power(light.power) }),
    ...(light.intensity && { intensity: power(light.intensity) }),
  }),
  lights: (light, origin) => {
    const position = subtract(light.position, origin);
    const { intensity, outer, sharpness } = spotCone(light);
    const normal = normalize(light.direction);
    return [
      {
        kind: "spot",
        position,
        size: light.radius,
        edge1: [outer, sharpness, 0],
        edge2: [0, 0, 0],
        normal,
        radiance: intensity,
        primitive: undefined,
        strength: sum(intensity),
        front: normal,
        bound: { center: position, radius: light.radius },
      },
    ];
  },
  sampler: { sample: "package::lights::spot::sampleSpot(p, light, u)", measure: "none" },
};
