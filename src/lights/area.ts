import type { LightKind } from "./light";

export const quad: LightKind = {
  sampler: { sample: "package::lights::area::samplePlanar(p, light, u)", measure: "area" },
};

export const triangle: LightKind = {
  sampler: {
    sample: "package::lights::area::samplePlanar(p, light, package::lights::area::squareToTriangle(u))",
    measure: "area",
  },
};
