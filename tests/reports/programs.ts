// Whether a change of the compiler changes what it makes: node src/cli/run.mjs tests/reports/programs.ts OUT.json [BEFORE.json]
// With --pictures as well, whether the pictures stay the same: of every tenth scene, with either program.
//
// Writes a digest of every program, uniform and tree of the reference scenes, of each shape with each material and light, and of
// random scenes, and names those that differ from an earlier file. Of a program's text comments, white space and the order of
// its declarations do not count.
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { requestDawnDevice } from "../../src/cli/dawn";
import { compileScene } from "../../src/compile/compileScene";
import type { ProgramSettings } from "../../src/compile/features";
import { linkProgram } from "../../src/compile/linkProgram";
import { PathTracer } from "../../src/renderer/pathTracer";
import { parseScene } from "../../src/scene/parseScene";
import type { Scene } from "../../src/scene/schema";
import { prepareGeometry } from "../../src/tree/geometry";
import { CROWDS, LIGHTS, MATERIALS, meshScenes, PRIMITIVES, sceneOf } from "../shaders/programs";
import { randomScene } from "../support/randomScene";
import { loadReference, REFERENCE_NAMES } from "../support/reference";

const RANDOM_SCENES = 60;
const MOST_NAMED = 20;

type Digests = Record<string, string>;

export async function main(args: string[]): Promise<void> {
  const [out, before] = args.filter((arg) => !arg.startsWith("--"));
  if (out === undefined) throw new Error("usage: programs.ts OUT.json [BEFORE.json] [--pictures]");
  const device = args.includes("--pictures") ? await requestDawnDevice() : undefined;
  const digests: Digests = {};
  let count = 0;
  for (const [name, scene] of scenes()) {
    await digest(name, scene, digests);
    if (device && count % 10 === 0) await digestPictures(name, scene, device, digests);
    count++;
  }
  writeFileSync(out, `${JSON.stringify(digests, null, 1)}\n`);
  const entries = Object.entries(digests);
  console.log(`${entries.length} digests of ${count} scenes`);
  if (before === undefined) return;
  const old = JSON.parse(readFileSync(before, "utf8")) as Digests;
  const names = new Set([...Object.keys(old), ...entries.map(([name]) => name)]);
  const different = [...names].filter((name) => old[name] !== digests[name]);
  const shown = different.slice(0, MOST_NAMED).map((name) => `\n  ${name}`);
  console.log(
    different.length === 0 ? "none differs" : `${different.length} differ, the first of them${shown.join("")}`,
  );
  if (different.length > 0) process.exitCode = 1;
}

function* scenes(): Generator<[string, Scene]> {
  for (const name of REFERENCE_NAMES) yield [name, loadReference(name).scene];
  for (const [shape, object] of Object.entries(PRIMITIVES)) {
    for (const [material, value] of Object.entries(MATERIALS)) {
      for (const [light, lights] of Object.entries(LIGHTS)) {
        yield [`${shape}, ${material}, ${light}`, sceneOf([object], { m: value }, lights, [1, 1, 1])];
      }
    }
  }
  for (const [material, value] of Object.entries(MATERIALS)) {
    for (const [i, scene] of meshScenes(value).entries()) yield [`mesh ${i}, ${material}`, scene];
    yield [
      `all shapes, ${material}`,
      sceneOf(Object.values(PRIMITIVES), { m: value }, LIGHTS["lights of both kinds"]!, [0, 0, 0]),
    ];
  }
  for (const [name, { objects, lights }] of Object.entries(CROWDS)) {
    yield [name, sceneOf(objects, { m: {}, ...MATERIALS }, lights, [1, 1, 1])];
  }
  for (let seed = 1; seed <= RANDOM_SCENES; seed++) {
    const { scene } = randomScene(seed);
    yield [`random ${seed}`, scene];
    // So many that a tree, loops and tables of lights are needed.
    const objects = Array.from({ length: 8 }, () => scene.objects).flat();
    if (seed % 4 === 0) yield [`random ${seed}, eight times`, { ...scene, objects }];
  }
}

const SETTINGS: Readonly<Record<string, ProgramSettings>> = {
  path: { estimator: "path", sampler: "sobol", lightSamples: 1 },
  "uniform, two light samples": { estimator: "uniform", sampler: "independent", lightSamples: 2 },
};

async function digest(name: string, scene: Scene, digests: Digests): Promise<void> {
  const resolved = parseScene(scene);
  const geometry = await prepareGeometry(resolved);
  for (const [title, settings] of Object.entries(SETTINGS)) {
    for (const camera of [undefined, resolved.camera]) {
      const { sceneModule, features, uniform, description } = compileScene(resolved, settings, camera, geometry);
      const wgsl = await linkProgram(sceneModule, features);
      const key = `${name}: ${title}${camera ? ", at rest" : ""}`;
      digests[key] = [normalized(wgsl), new Uint8Array(uniform), description.join()].map(hash).join(" ");
    }
  }
  if (!geometry) return;
  const buffers = Object.values(geometry.data).filter((data) => data instanceof ArrayBuffer);
  digests[`${name}: geometry`] = buffers.map((buffer) => hash(new Uint8Array(buffer))).join(" ");
}

async function digestPictures(name: string, scene: Scene, device: GPUDevice, digests: Digests): Promise<void> {
  for (const [title, settings] of Object.entries(SETTINGS)) {
    for (const constants of [false, true]) {
      const tracer = await PathTracer.create({
        scene,
        width: 24,
        height: 24,
        settings: { ...settings, constants },
        device,
      });
      if (constants) await tracer.compile();
      await tracer.sample(4);
      digests[`${name}: ${title}, picture${constants ? ", at rest" : ""}`] = hash(
        new Uint8Array((await tracer.readRadiance()).buffer),
      );
      tracer.dispose();
    }
  }
}

function hash(data: string | Uint8Array): string {
  return createHash("sha256").update(data).digest("hex").slice(0, 12);
}

/** Declarations in alphabetical order, without comments and with single spaces. */
function normalized(wgsl: string): string {
  const text = wgsl.replace(/\/\/.*$/gm, "");
  return text
    .split(/(?<=[;}])\n(?=\S)/)
    .map((declaration) => declaration.replace(/\s+/g, " ").trim())
    .sort()
    .join("\n");
}
