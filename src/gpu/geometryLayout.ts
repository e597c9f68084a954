import type { Features } from "../compile/features";
import type { GeometryData } from "../compile/geometry";
import { ShaderStage } from "./flags";

export type GeometryPart = keyof GeometryData;

/** Bindings of the trace pass's group that hold geometry, as `wgsl/tree.wgsl`, `mesh.wgsl` and `lights.wgsl` declare them. */
export const GEOMETRY_BINDINGS: Readonly<
  Record<GeometryPart, { readonly binding: number; readonly isTexture?: boolean }>
> = {
  nodes: { binding: 5, isTexture: true },
  items: { binding: 6, isTexture: true },
  normals: { binding: 7 },
  shiningTriangles: { binding: 8 },
  uvs: { binding: 9 },
  texels: { binding: 10 },
};

/** What a program with these features reads. */
export function geometryLayout({ TREE, SMOOTH, MESH_LIGHTS, TEXTURES }: Features): GPUBindGroupLayoutEntry[] {
  const parts: readonly GeometryPart[] = [
    ...(TREE ? (["nodes", "items"] as const) : []),
    ...(SMOOTH ? (["normals"] as const) : []),
    ...(MESH_LIGHTS ? (["shiningTriangles"] as const) : []),
    ...(TEXTURES ? (["uvs", "texels"] as const) : []),
  ];
  return parts.map((part) => {
    const { binding, isTexture } = GEOMETRY_BINDINGS[part];
    const visibility = ShaderStage.COMPUTE;
    if (isTexture) return { binding, visibility, texture: { sampleType: "uint" } };
    return { binding, visibility, buffer: { type: "read-only-storage" } };
  });
}
