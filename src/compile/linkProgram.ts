import { link } from "wesl/core";
import type { Features } from "./features";

type Modules = Readonly<Record<string, string>>;

/** The shader modules that every page needs, by their path from `src`, as text. */
const MODULES = named(
  import.meta.glob<string>(
    [
      "../{wgsl,shapes,lights,lobes}/*.wgsl",
      "!../shapes/mesh.wgsl",
      "!../lights/mesh.wgsl",
      "!../lobes/multiscatter.wgsl",
      "!../wgsl/tree.wgsl",
      "!../wgsl/textures.wgsl",
      "!../wgsl/baseline.wgsl",
      "!../wgsl/pick.wgsl",
    ],
    { query: "?raw", import: "default", eager: true },
  ),
);

/** Links a shader module of ours that needs no scene. */
export async function linkModule(rootModuleName: string): Promise<string> {
  const { dest } = await link({ weslSrc: MODULES, rootModuleName });
  return dest;
}

/** Links the tracer for one scene, or what picks in it: `sceneModule` is what `emitScene` wrote. */
export async function linkProgram(
  sceneModule: string,
  features: Features,
  rootModuleName: "trace" | "pick" = "trace",
): Promise<string> {
  // What few scenes need is loaded when one does.
  const { default: estimator } = features.UNIFORM
    ? await import("../wgsl/baseline.wgsl?raw")
    : { default: MODULES["./path.wgsl"]! };
  const onDemand: Modules = {
    ...(features.TREE && named((await import("./treeModules")).TREE_MODULES)),
    ...(features.MULTISCATTER && {
      "./lobes/multiscatter.wgsl": (await import("../lobes/multiscatter.wgsl?raw")).default,
    }),
    ...(rootModuleName === "pick" && { "./pick.wgsl": (await import("../wgsl/pick.wgsl?raw")).default }),
  };
  const { dest } = await link({
    weslSrc: { ...MODULES, ...onDemand, "./scene.wgsl": sceneModule, "./estimator.wgsl": estimator },
    rootModuleName,
    conditions: features,
    sourceMap: false,
  });
  return dest;
}

function named(modules: Modules): Modules {
  return Object.fromEntries(
    Object.entries(modules).map(([path, text]) => [path.replace(/^\.\.\/(wgsl\/)?/, "./"), text]),
  );
}
