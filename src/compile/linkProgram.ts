import type { Features } from "./features";
import { type Conditions, link, parseModule, type ShaderModule } from "./link";

/** The shader modules that every page needs, by their path from here, as text. */
const AT_ONCE = import.meta.glob<string>(
  [
    "../{wgsl,shapes,lights,lobes}/*.wgsl",
    "!../{shapes,lights}/mesh.wgsl",
    "!../lobes/{multiscatter,refraction,roughRefraction,roughWall,diffuseTransmission,sheen,clearcoat,anisotropy,iridescence}.wgsl",
    "!../wgsl/{tree,textures,coverage,lens,baseline,pick,medium,dispersion,stretch}.wgsl",
  ],
  { query: "?raw", import: "default", eager: true },
);

/** Those that few scenes need: each is loaded when one does. */
const ON_DEMAND = import.meta.glob<string>(
  [
    "../{shapes,lights}/mesh.wgsl",
    "../lobes/{multiscatter,refraction,roughRefraction,roughWall,diffuseTransmission,sheen,clearcoat,anisotropy,iridescence}.wgsl",
    "../wgsl/{tree,textures,coverage,lens,baseline,pick,medium,dispersion,stretch}.wgsl",
  ],
  { query: "?raw", import: "default" },
);

/** Those taken apart so far, by the path that imports name. */
const modules = new Map<string, ShaderModule>();

/** The file of a module, from here. Those of `wgsl/` are named without it. */
function fileOf(path: string): string {
  return `../${path.includes("/") ? "" : "wgsl/"}${path}.wgsl`;
}

function moduleAt(path: string): ShaderModule | undefined {
  const text = AT_ONCE[fileOf(path)];
  if (!modules.has(path) && text !== undefined) modules.set(path, parseModule(text));
  return modules.get(path);
}

/** Links a shader module of ours that needs no scene. */
export function linkModule(root: string): Promise<string> {
  return linkFrom({}, root, {});
}

/** Links the tracer for one scene, or what picks in it: `sceneModule` is what `emitScene` wrote. */
export function linkProgram(
  sceneModule: string,
  features: Features,
  root: "trace" | "pick" = "trace",
): Promise<string> {
  const estimator = features.UNIFORM ? "baseline" : "path";
  return linkFrom({ scene: parseModule(sceneModule), estimator }, root, { ...features, PICK: root === "pick" });
}

/** @param given - modules that are only known now, or the paths of those that stand for them. */
async function linkFrom(
  given: Readonly<Record<string, ShaderModule | string>>,
  root: string,
  conditions: Conditions,
): Promise<string> {
  for (;;) {
    const missing = new Set<string>();
    const find = (name: string): ShaderModule | undefined => {
      const path = given[name] ?? name;
      const module = typeof path === "string" ? moduleAt(path) : path;
      if (!module) missing.add(path as string);
      return module;
    };
    const text = link(find, root, conditions);
    if (missing.size === 0) return text;
    for (const path of missing) modules.set(path, parseModule(await ON_DEMAND[fileOf(path)]!()));
  }
}
