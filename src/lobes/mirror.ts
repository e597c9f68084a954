import { isMirror } from "./fresnel";
import type { Lobe } from "./lobe";

/** An interface without microfacets. */
export const mirror = {
  feature: "MIRROR",
  features: { MIRROR: { word: "mirror", isIn: isMirror } },
  columns: {},
  share: "package::lobes::mirror::mirrorShare(bsdf, wo)",
  delta: "package::lobes::mirror::mirrorSample(bsdf, wo, share)",
} as const satisfies Lobe;
