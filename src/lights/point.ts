import { scale, subtract } from "../math/vec3";
import type { ResolvedLight } from "../scene/schema";
import { ALL_ROUND, type SceneLight, sum } from "./light";

export const point: SceneLight<ResolvedLight & { type: "point" }> = {
  measure: (light, { point, power }) => ({ ...light, position: point(light.position), power: power(light.power) }),
  lights: (light, origin) => {
    const position = subtract(light.position, origin);
    const radiance = scale(light.power, 1 / (4 * Math.PI));
    const bound = { center: position, radius: 0 };
    return [
      {
        ...ALL_ROUND,
        kind: "point",
        position,
        size: 0,
        radiance,
        primitive: undefined,
        strength: sum(radiance),
        bound,
      },
    ];
  },
  sampler: { sample: "package::lights::point::samplePosition(p, light.position)", measure: "none" },
};
