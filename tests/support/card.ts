import type { Mesh } from "../../src/scene/meshes";
import type { Material, Scene } from "../../src/scene/schema";

/**
 * A square of 2 × 2 of material `m`, bottom left corner first, that fills a square picture. It is lit by nothing; its material has no
 * interface unless it says so.
 */
export function cardScene(material: Material, mesh: Partial<Mesh> = {}, more: Partial<Scene> = {}): Scene {
  return {
    camera: { position: [0, 0, 100], target: [0, 0, 0], verticalFov: (360 / Math.PI) * Math.atan(1 / 100) },
    materials: { m: { ior: 1, ...material } },
    objects: [
      {
        type: "mesh",
        positions: [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0],
        indices: [0, 1, 2, 0, 2, 3],
        material: "m",
        ...mesh,
      },
    ],
    ...more,
  };
}

/** A sky of radiance 1, which light reaches the card from at once. */
export const WHITE_SKY = { environment: { radiance: [1, 1, 1] }, maxBounces: 1 } as const satisfies Partial<Scene>;
