import type { ResolvedMaterial } from "../scene/schema";
import type { MaterialPart } from "./lobe";

/** Whether a surface emits from its back too. */
export function emitsTwice({ doubleSided, emission }: ResolvedMaterial): boolean {
  return doubleSided && emission.some((value) => value > 0);
}

/** From which sides a surface emits, and whether that is the colour of what is unlit. */
export const sides = {
  features: { DOUBLE_SIDED: { isIn: emitsTwice } },
  columns: {
    doubleSided: {
      type: "f32",
      when: ({ DOUBLE_SIDED }) => DOUBLE_SIDED!,
      of: (material) => (emitsTwice(material) ? 1 : 0),
    },
    // Vertices colour what is unlit, and no other emission.
    unlit: {
      type: "f32",
      when: ({ UNLIT_COLORS }) => UNLIT_COLORS!,
      of: ({ unlit }) => (unlit ? 1 : 0),
    },
  },
} as const satisfies MaterialPart;
