import { link } from "wesl/core";
import type { Features } from "./features";

/** The shader modules of `src/wgsl`, by file name, as text. */
const MODULES: Readonly<Record<string, string>> = Object.fromEntries(
  Object.entries(import.meta.glob<string>("../wgsl/*.wgsl", { query: "?raw", import: "default", eager: true })).map(
    ([path, text]) => [path.replace("../wgsl/", "./"), text],
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
  const estimator = MODULES[features.UNIFORM ? "./uniform.wgsl" : "./path.wgsl"]!;
  const { dest } = await link({
    weslSrc: { ...MODULES, "./scene.wgsl": sceneModule, "./estimator.wgsl": estimator },
    rootModuleName,
    conditions: features,
    sourceMap: false,
  });
  return dest;
}
