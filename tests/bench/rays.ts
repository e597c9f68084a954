import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { requestDawnDevice } from "../../src/cli/dawn";
import { compileScene } from "../../src/compile/compileScene";
import { adapterName } from "../../src/gpu/device";
import { parseScene } from "../../src/scene/parseScene";
import { prepareGeometry } from "../../src/tree/geometry";
import { bumpySphere, type MeshData, meshObject } from "../support/meshes";
import { probeOn } from "../support/probeOn";
import { createRandom, randomDirection } from "../support/random";
import { describeMachine } from "./machine";

// Closest hits per second on meshes of ever more triangles, ours and Embree's on the same rays:
//   RT_VIEWER_EMBREE_PYTHON=… node src/cli/run.mjs tests/bench/rays.ts
// with a Python that has embreex. Embree runs on one thread, our adapter on all it has.

const RESULTS = fileURLToPath(new URL("results/rays.json", import.meta.url));
const EMBREE = fileURLToPath(new URL("rivals/embree_rays.py", import.meta.url));
const SIZES = [1e3, 1e4, 1e5, 1e6];
const RAYS = 2 ** 17;
const SEED = 1;
// What a dispatch takes beside its rays cancels out between one pass and this many.
const PASSES = 9;

type Row = {
  readonly triangles: number;
  /** Share of the rays that hit. */
  readonly hits: number;
  readonly ourRaysPerSecond: number;
  readonly embreeRaysPerSecond: number;
  /** Rays for which one of both finds a hit and the other does not, or another distance by more than 10⁻⁵ of it. */
  readonly disagreements: number;
};

export async function main(): Promise<void> {
  const python = process.env.RT_VIEWER_EMBREE_PYTHON ?? "python3";
  const device = await requestDawnDevice();
  const rays = raysThrough(RAYS, SEED);
  const rows: Row[] = [];
  let renderer = "";
  for (const size of SIZES) {
    const mesh = bumpySphere(size);
    const ours = await traceOurs(device, mesh, rays);
    const embree = traceEmbree(python, mesh, rays);
    renderer = embree.renderer;
    rows.push({
      triangles: mesh.indices.length / 3,
      hits: ours.distances.filter((t) => t < FAR).length / RAYS,
      ourRaysPerSecond: Math.round(RAYS / ours.seconds),
      embreeRaysPerSecond: Math.round(RAYS / embree.seconds),
      disagreements: ours.distances.filter((t, i) => !agree(t, embree.distances[i]!)).length,
    });
    console.log(JSON.stringify(rows.at(-1)));
  }
  const report = {
    machine: describeMachine(undefined),
    adapter: adapterName(device),
    embree: renderer,
    rays: RAYS,
    seed: SEED,
    rows,
  };
  writeFileSync(RESULTS, `${JSON.stringify(report, undefined, 2)}\n`);
  device.destroy();
}

/** From a sphere of radius 2 to points in one of 0.6, six numbers each: neighbours have nothing in common. */
function raysThrough(count: number, seed: number): Float32Array {
  const random = createRandom(seed);
  const rays = new Float32Array(6 * count);
  for (let i = 0; i < count; i++) {
    const origin = randomDirection(random).map((x) => 2 * x);
    const radius = 0.6 * Math.cbrt(random());
    const way = randomDirection(random).map((x, axis) => radius * x - origin[axis]!);
    const length = Math.hypot(...way);
    rays.set([...origin, ...way.map((x) => x / length)], 6 * i);
  }
  return rays;
}

// Beyond it, a distance says that there is no hit: 1e18 of ours, 1e37 of Embree.
const FAR = 1e17;

type Traced = { readonly seconds: number; readonly distances: Float32Array };

async function traceOurs(device: GPUDevice, mesh: MeshData, rays: Float32Array): Promise<Traced> {
  const scene = parseScene({
    camera: { position: [0, 0, 3], target: [0, 0, 0] },
    materials: { white: {} },
    objects: [meshObject(mesh, "white")],
  });
  const geometry = await prepareGeometry(scene);
  const settings = { estimator: "path", sampler: "sobol", lightSamples: 1 } as const;
  const { sceneModule, features, uniform, isStored } = compileScene(scene, settings, undefined, geometry);
  const inputs = new Float32Array(8 * RAYS);
  for (let i = 0; i < RAYS; i++) {
    inputs.set(rays.subarray(6 * i, 6 * i + 3), 8 * i);
    inputs.set(rays.subarray(6 * i + 3, 6 * i + 6), 8 * i + 4);
  }
  const trace = async (passes: number) => {
    const start = performance.now();
    const words = await probeOn(device, {
      wgsl: `
        import package::constants::NONE;
        import package::ray::makeRay;
        import package::scene::closestHit;
        fn probe(i: u32) {
          for (var pass_ = 0u; pass_ < ${passes}u; pass_++) {
            let hit = closestHit(makeRay(bitcast<vec4f>(inputs[2u * i]).xyz, bitcast<vec4f>(inputs[2u * i + 1u]).xyz, NONE));
            outputs[i] = vec4u(bitcast<u32>(hit.t));
          }
        }`,
      conditions: features,
      modules: { scene: sceneModule },
      scene: uniform,
      geometry,
      isStored,
      count: RAYS,
      inputs,
      outputRows: RAYS,
    });
    return { seconds: (performance.now() - start) / 1000, words };
  };
  const { words } = await trace(1);
  const once = Math.min((await trace(1)).seconds, (await trace(1)).seconds);
  const often = Math.min((await trace(PASSES)).seconds, (await trace(PASSES)).seconds);
  const distances = new Float32Array(words.buffer).filter((_, i) => i % 4 === 0);
  return { seconds: (often - once) / (PASSES - 1), distances };
}

function traceEmbree(python: string, mesh: MeshData, rays: Float32Array): Traced & { readonly renderer: string } {
  const folder = mkdtempSync(join(tmpdir(), "rt-viewer-rays-"));
  try {
    const file = (name: string) => join(folder, name);
    writeFileSync(file("vertices"), Float32Array.from(mesh.positions));
    writeFileSync(file("triangles"), Uint32Array.from(mesh.indices));
    writeFileSync(file("rays"), rays);
    const names = ["vertices", "triangles", "rays", "distances"].map(file);
    const { renderer, seconds } = JSON.parse(execFileSync(python, [EMBREE, ...names], { encoding: "utf8" }));
    const bytes = readFileSync(file("distances"));
    const distances = new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
    return { renderer, seconds, distances };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

function agree(ours: number, theirs: number): boolean {
  const [isHit, isTheirs] = [ours < FAR, theirs < FAR];
  return isHit === isTheirs && (!isHit || Math.abs(ours - theirs) <= 1e-5 * ours);
}
