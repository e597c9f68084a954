import { fileURLToPath } from "node:url";
import { loadReference } from "../support/reference";
import type { ChromiumHost } from "./chromiumHost";
import { type Host, type Measurement, type MeasureOptions, VARIANTS } from "./measurement";
import type { Options, RendererId, SceneName } from "./options";
import type { Entrant, NotMeasured } from "./results";
import { findPython, measurePython, PYTHON_RIVALS } from "./rivals";

/** Someone who takes part. */
export type Renderer = Pick<Entrant, "id" | "host"> & {
  readonly measure: (scene: SceneName, options: MeasureOptions) => Promise<Measurement>;
  /** The scenes it takes part in, if not all. */
  readonly scenes?: readonly SceneName[];
};

// three-gpu-pathtracer compiles for half a minute before every render. These show all that it samples: an area light, a point
// light, a sky; and what it does with a light that it cannot sample.
const THREE_SCENES: readonly SceneName[] = ["cornell", "bleed", "spheres"];

/** Those who were asked for and can take part, and why others can't. */
export async function findRenderers(
  { renderers }: Pick<Options, "renderers">,
  hosts: readonly Host[],
  chromium: ChromiumHost | undefined,
): Promise<{ renderers: Renderer[]; notMeasured: NotMeasured[] }> {
  const found: Renderer[] = [];
  const notMeasured: NotMeasured[] = [];
  const isWanted = (id: RendererId) => renderers.includes(id);

  for (const host of hosts) {
    for (const id of VARIANTS.filter(isWanted)) {
      const measure: Renderer["measure"] = (scene, options) => host.measure(id, sceneOf(scene), options);
      found.push({ id, host: host.name, measure });
    }
  }
  if (isWanted("three-gpu-pathtracer")) {
    if (chromium) {
      const measure: Renderer["measure"] = (scene, options) => chromium.threeGpuPathTracer(sceneOf(scene), options);
      found.push({ id: "three-gpu-pathtracer", host: "Chromium", measure, scenes: THREE_SCENES });
    } else notMeasured.push({ id: "three-gpu-pathtracer", reason: "it runs in Chromium only" });
  }
  for (const rival of PYTHON_RIVALS.filter(({ id }) => isWanted(id))) {
    const { id, needs, variable } = rival;
    const python = await findPython(rival);
    if (python === undefined) {
      notMeasured.push({ id, reason: `no Python with ${needs}; name one in ${variable}` });
      continue;
    }
    const measure: Renderer["measure"] = (scene, options) => measurePython(python, id, fileOf(scene), options);
    found.push({ id, host: "Python", measure });
  }
  return { renderers: found, notMeasured };
}

function sceneOf(name: SceneName) {
  return loadReference(name).scene;
}

function fileOf(name: SceneName): string {
  return fileURLToPath(new URL(`../reference/scenes/${name}.json`, import.meta.url));
}
