/** The feature pages in the order in which they are read. A name is that of a `.html` and a `.ts` file beside this one. */
export const FEATURE_GROUPS = [
  { title: "Light", names: ["soft-shadows", "emission", "ambient-light", "bounces"] },
  {
    title: "Surfaces",
    names: ["color-bleeding", "metals", "roughness", "mirror", "glass", "fabrics-and-coats", "cut-outs"],
  },
  { title: "Shapes", names: ["meshes", "files"] },
  { title: "Camera", names: ["camera", "lens", "orthographic"] },
  { title: "Precision", names: ["energy", "target-error", "estimators"] },
] as const;

export const FEATURE_NAMES: readonly string[] = FEATURE_GROUPS.flatMap(({ names }) => names);
