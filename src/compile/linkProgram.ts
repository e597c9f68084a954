import { link } from "wesl/core";
import type { Features } from "./features";

type Modules = Readonly<Record<string, string>>;

/** The shader modules of `src/wgsl` that every page needs, by file name, as text. */
const MODULES = named(
  import.meta.glob<string>(
    [
      "../wgsl/*.wgsl",
      "!../wgsl/tree.wgsl",
      "!../wgsl/mesh.wgsl",
      "!../wgsl/meshLights.wgsl",
      "!../wgsl/multiscatter.wgsl",
      "!../wgsl/textures.wgsl",
      "!../wgsl/uniform.wgsl",
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
  const estimator = features.UNIFORM ? await uniformEstimator() : MODULES["./path.wgsl"]!;
  const root = rootModuleName === "pick" ? { "./pick.wgsl": await pickModule() } : {};
  const tree = features.TREE ? await treeModules() : {};
  const multiscatter = features.MULTISCATTER ? { "./multiscatter.wgsl": await multiscatterModule() } : {};
  const { dest } = await link({
    weslSrc: {
      ...MODULES,
      ...tree,
      ...multiscatter,
      ...root,
      "./scene.wgsl": sceneModule,
      "./estimator.wgsl": estimator,
    },
    rootModuleName,
    conditions: features,
    sourceMap: false,
  });
  return dest;
}

// What few scenes need is loaded when one does.

async function treeModules(): Promise<Modules> {
  return named((await import("./treeModules")).TREE_MODULES);
}

async function uniformEstimator(): Promise<string> {
  return (await import("../wgsl/uniform.wgsl?raw")).default;
}

async function multiscatterModule(): Promise<string> {
  return (await import("../wgsl/multiscatter.wgsl?raw")).default;
}

async function pickModule(): Promise<string> {
  return (await import("../wgsl/pick.wgsl?raw")).default;
}

function named(modules: Modules): Modules {
  return Object.fromEntries(Object.entries(modules).map(([path, text]) => [path.replace("../wgsl/", "./"), text]));
}
