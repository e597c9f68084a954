import type { MeshObject } from "../shapes/shapes";
import type { MeshPart } from "./meshPart";

/**
 * What the vertices of triangles have beside positions and normals, in pairs of f32: texture coordinates first; then, where some mesh
 * has them, colours, tangents and a second set of texture coordinates.
 */
export type VertexLayout = {
  /** Pairs of a vertex. */
  readonly stride: number;
  /** Where in a vertex they start; undefined where no mesh has them or nothing asks for them. */
  readonly uvs?: number;
  readonly colors?: number;
  readonly tangents?: number;
  readonly uvs1?: number;
};

/** @param usesUvs - whether anything asks for texture coordinates and tangents. */
export function vertexLayoutOf(parts: readonly MeshPart[], usesUvs: boolean): VertexLayout {
  let stride = usesUvs ? 1 : 0;
  const place = (field: "colors" | "tangents" | "uvs1", pairs: number) => {
    if (!parts.some(({ object }) => object[field] !== undefined)) return {};
    stride += pairs;
    return { [field]: stride - pairs };
  };
  const colors = place("colors", 2);
  const ofTextures = usesUvs ? { uvs: 0, ...place("tangents", 2), ...place("uvs1", 1) } : {};
  return { stride, ...colors, ...ofTextures };
}

/** Writes what a vertex has, from `at` on. What its mesh lacks is zero; a colour white. */
export function writeVertex(
  floats: Float32Array,
  at: number,
  vertex: number,
  { uvs, uvs1, colors, tangents }: MeshObject,
  layout: VertexLayout,
): void {
  const write = (values: Float32Array, size: number, pair: number) => {
    for (let i = 0; i < size; i++) floats[at + 2 * pair + i] = values[size * vertex + i]!;
  };
  if (uvs && layout.uvs !== undefined) write(uvs, 2, layout.uvs);
  if (uvs1 && layout.uvs1 !== undefined) write(uvs1, 2, layout.uvs1);
  if (tangents && layout.tangents !== undefined) write(tangents, 4, layout.tangents);
  if (layout.colors === undefined) return;
  if (colors) write(colors, 4, layout.colors);
  else floats.fill(1, at + 2 * layout.colors, at + 2 * layout.colors + 4);
}
