/** The shader modules that only scenes with a tree need, by file name, as text. A chunk of its own. */
export const TREE_MODULES: Readonly<Record<string, string>> = import.meta.glob<string>(
  ["../wgsl/tree.wgsl", "../wgsl/textures.wgsl", "../shapes/mesh.wgsl", "../lights/mesh.wgsl"],
  { query: "?raw", import: "default", eager: true },
);
