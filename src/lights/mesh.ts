import type { LightKind } from "./light";

export const mesh: LightKind = {
  sampler: { sample: "package::lights::mesh::sampleMesh(p, light, u, pick)", measure: "area" },
};
