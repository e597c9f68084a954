import type { LightKind } from "./light";

const calls = { area: ["samplePlanar", "squareToTriangle"] };

export const quad: LightKind = { sampler: { calls, sample: "samplePlanar(p, light, u)", measure: "area" } };

export const triangle: LightKind = {
  sampler: { calls, sample: "samplePlanar(p, light, squareToTriangle(u))", measure: "area" },
};
