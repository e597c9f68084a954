import type { LightKind } from "./light";

export const mesh: LightKind = {
  sampler: { sample: "package::lights::mesh::sampleMesh(p, light, u, pick)", measure: "area" },
  // The third number says which side.
  turn: (light) => ({ ...light, position: [light.position[0], light.position[1], 1] }),
};
