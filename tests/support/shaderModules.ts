/** The shader modules of `src` as text, by the paths that imports name. */
export const SHADER_MODULES: Readonly<Record<string, string>> = Object.fromEntries(
  Object.entries(
    import.meta.glob<string>("../../src/{wgsl,shapes,lights,lobes}/*.wgsl", {
      query: "?raw",
      import: "default",
      eager: true,
    }),
  ).map(([path, text]) => [path.replace(/.*\/src\/(?:wgsl\/)?(.*)\.wgsl/, "$1"), text]),
);
