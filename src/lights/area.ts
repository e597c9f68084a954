import { type LightKind, turned } from "./light";

export const quad: LightKind = {
  sampler: { sample: "package::lights::area::samplePlanar(p, light, u)", measure: "area" },
  turn: turned,
};

export const triangle: LightKind = {
  sampler: {
    sample: "package::lights::area::samplePlanar(p, light, package::lights::area::squareToTriangle(u))",
    measure: "area",
  },
  turn: turned,
};
