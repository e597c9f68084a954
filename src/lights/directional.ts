import { cross, normalize, scale } from "../math/vec3";
import type { ResolvedLight, Vec3 } from "../scene/schema";
import { type SceneLight, sum } from "./light";

/**
 * A sun: light from infinitely far away, all from one direction or evenly from a disk in the sky. The radiance of a disk with the
 * angular radius h is irradiance / (π·sin²h), because the integral of the cosine over it is π·sin²h where it is faced.
 */
export const directional: SceneLight<ResolvedLight & { type: "directional" }> = {
  isDistant: true,
  measure: (light) => light, // watts per area, like radiance, stay
  lights: ({ direction, irradiance, angularDiameter }) => {
    const radius = angularDiameter < LEAST_DIAMETER ? 0 : (angularDiameter * Math.PI) / 360;
    const normal = normalize(scale(direction, -1));
    const edge1 = normalize(cross(normal, leastAxis(normal)));
    const edge2 = cross(normal, edge1);
    const radiance = radius > 0 ? scale(irradiance, 1 / (Math.PI * Math.sin(radius) ** 2)) : irradiance;
    return [
      {
        kind: "directional",
        position: [0, 0, 0],
        // 1 − cos, without its cancellation.
        size: 2 * Math.sin(radius / 2) ** 2,
        edge1,
        edge2,
        normal,
        radiance,
        primitive: undefined,
        strength: sum(irradiance),
        front: undefined,
        bound: { center: normal, radius: 2 * Math.sin(radius / 2) },
      },
    ];
  },
  sampler: { sample: "package::lights::directional::sampleSky(light, u)", measure: "none" },
};

// Degrees. Directions in f32 are 140 times as fine: what is smaller is a point.
const LEAST_DIAMETER = 1e-3;

/** The axis that a vector is farthest from. */
function leastAxis(v: Vec3): Vec3 {
  const [x, y, z] = [Math.abs(v[0]), Math.abs(v[1]), Math.abs(v[2])];
  if (x <= y && x <= z) return [1, 0, 0];
  return y <= z ? [0, 1, 0] : [0, 0, 1];
}
