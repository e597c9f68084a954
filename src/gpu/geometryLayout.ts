import type { Features } from "../compile/features";
import type { GeometryData } from "../tree/geometry";
import { ShaderStage } from "./flags";

export type GeometryPart = keyof GeometryData;

/** Where a part of the geometry is in the trace pass's group, and what a program must have to read it. */
type Binding = {
  readonly binding: number;
  readonly feature: keyof Features;
  /** Texels in a row of what is a texture: whole records, and no more than every device has. */
  readonly row?: number;
};

/** As `wgsl/tree.wgsl`, `wgsl/textures.wgsl`, `shapes/mesh.wgsl` and `lights/mesh.wgsl` declare them. */
export const GEOMETRY_BINDINGS: Readonly<Record<GeometryPart, Binding>> = {
  nodes: { binding: 5, feature: "TREE", row: 4096 * 2 },
  items: { binding: 6, feature: "TREE", row: 2048 * 3 },
  normals: { binding: 7, feature: "SMOOTH" },
  emissiveTriangles: { binding: 8, feature: "LIGHT_PICKS" },
  vertices: { binding: 9, feature: "VERTICES" },
  texels: { binding: 10, feature: "TEXTURES" },
};

/** What a program with these features reads. */
export function geometryLayout(features: Features): GPUBindGroupLayoutEntry[] {
  return Object.values(GEOMETRY_BINDINGS)
    .filter(({ feature }) => features[feature])
    .map(({ binding, row }) => ({
      binding,
      visibility: ShaderStage.COMPUTE,
      ...(row ? { texture: { sampleType: "uint" } } : { buffer: { type: "read-only-storage" } }),
    }));
}
