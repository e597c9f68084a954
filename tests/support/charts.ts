// Parts of the sphere of directions in coordinates that take the peak out of a lobe, binned; see directionBins.ts.
//
// [1] Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", eq. 14, 16, 17
import type { Vec3 } from "../../src/scene/schema";
import { BIN_COUNT, binDirections, binOf, dot, normalize, type Polar } from "./directionBins";
import { refracted } from "./interfaces";
import { type Alphas, add, scale } from "./khrMaterials";

/** Bins of the directions on one side of the surface; those that a horizon cuts are one, the last. */
export type Chart = {
  /** Directions to integrate a density over, with the solid angle that each stands for. */
  readonly nodes: readonly { readonly direction: Vec3; readonly solidAngle: number; readonly bin: number }[];
  /** Of a direction on the chart's side, which need not be exactly unit; undefined of those on the other. */
  readonly binOf: (direction: Vec3) => number | undefined;
};

/** Even bins above or below the surface: for what has no peak. */
export function evenChart(side: 1 | -1, steps: number): Chart {
  const polar: Polar = { axis: [0, 0, side], scale: 1, most: 1 };
  return {
    nodes: binDirections(polar, steps),
    binOf: (direction) => (side * direction[2] > 0 ? binOf(polar, direction) : undefined),
  };
}

/** By the normals of microfacets that send light to `wo`: `reflect` it, `pass` it to the mirror image below, or refract it by `eta`. */
export function normalsChart(
  wo: Vec3,
  alphas: Alphas,
  how: "reflect" | "pass" | { eta: number },
  steps: number,
): Chart {
  const ratio = alphas[0] / alphas[1];
  // Normals made isotropic, of which a linear map makes the surface's.
  const polar: Polar = { axis: [0, 0, 1], scale: alphas[1] ** 2 / 2, most: 1 };
  const side = how === "reflect" ? 1 : -1;
  const nodes = binDirections(polar, steps).flatMap(({ direction: [x, y, z], solidAngle, bin }) => {
    const stretched: Vec3 = [ratio * x, y, z];
    const m = normalize(stretched);
    const perNormal = (solidAngle * ratio) / Math.hypot(...stretched) ** 3;
    const node = directionOf(wo, m, how);
    if (!node || side * node.direction[2] <= 0) return [];
    return { direction: node.direction, bin, solidAngle: perNormal * node.perNormal };
  });
  const counts = new Uint16Array(BIN_COUNT);
  for (const { bin } of nodes) counts[bin]!++;
  const whole = (bin: number) => (counts[bin] === steps ** 2 ? bin : BIN_COUNT);
  return {
    nodes: nodes.map((node) => ({ ...node, bin: whole(node.bin) })),
    binOf: (direction) => {
      if (side * direction[2] <= 0) return undefined;
      const [x, y, z] = normalOf(wo, direction, how);
      const bin = z > 0 ? binOf(polar, normalize([x / ratio, y, z])) : undefined;
      return bin === undefined ? BIN_COUNT : whole(bin);
    },
  };
}

/** Where a microfacet sends light, and the solid angle there of a unit of solid angle of normals. [1] */
function directionOf(wo: Vec3, m: Vec3, how: "reflect" | "pass" | { eta: number }) {
  const cosine = dot(wo, m);
  if (cosine <= 0) return undefined;
  if (typeof how === "string") {
    const [x, y, z] = add(scale(m, 2 * cosine), scale(wo, -1));
    return { direction: [x, y, how === "pass" ? -z : z] as Vec3, perNormal: 4 * cosine };
  }
  const direction = refracted(wo, m, how.eta);
  if (!direction) return undefined;
  const cosI = dot(direction, m);
  return { direction, perNormal: (cosine + how.eta * cosI) ** 2 / (how.eta ** 2 * Math.abs(cosI)) };
}

function normalOf(wo: Vec3, wi: Vec3, how: "reflect" | "pass" | { eta: number }): Vec3 {
  if (how === "reflect") return add(wo, wi);
  if (how === "pass") return add(wo, [wi[0], wi[1], -wi[2]]);
  const sum = add(wo, scale(normalize(wi), how.eta));
  return sum[2] < 0 ? scale(sum, -1) : sum;
}

/** Bins of each of them. */
export const CHART_BINS = BIN_COUNT + 1;
