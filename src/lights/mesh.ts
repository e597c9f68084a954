import type { LightKind } from "./light";

export const mesh: LightKind = {
  sampler: { calls: { mesh: ["sampleMesh"] }, sample: "sampleMesh(p, light, u, pick)", measure: "area" },
};
