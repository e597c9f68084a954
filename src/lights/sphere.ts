import { scale } from "../math/vec3";
import type { ResolvedLight } from "../scene/schema";
import type { SceneLight } from "./light";

export const sphere: SceneLight<ResolvedLight & { type: "sphere" }> = {
  measure: (light, { point, size, power }) => {
    return { ...light, position: point(light.position), radius: size(light.radius), power: power(light.power) };
  },
  body: ({ position: center, radius, power }) => ({
    body: { type: "sphere", center, radius, material: "" },
    // Of a diffuse sphere that gives `power` watts: power / (4π²·radius²), by area × π.
    radiance: scale(power, 1 / (4 * Math.PI ** 2 * radius ** 2)),
  }),
  sampler: {
    sample: "package::lights::sphere::sampleSphere(p, light.position, light.size, u)",
    baseline: "package::lights::sphere::sampleSphereSurface(p, light.position, light.size, u)",
    measure: "cone",
  },
};
