import { compileScene } from "../../src/compile/compileScene";
import { parseScene } from "../../src/scene/parseScene";
import type { Scene, Vec3 } from "../../src/scene/schema";
import { prepareGeometry } from "../../src/tree/geometry";
import { runProbe } from "./probe";

export const NONE = 0xffffffff;
export const INSIDE = 0x80000000;

/** Whose intersection functions: the package's, or `support/textbook`. */
export type Method = "ours" | "textbook";

const TEXTBOOK: Readonly<Record<string, string>> = Object.fromEntries(
  Object.entries(
    import.meta.glob<string>("./textbook/**/*.wgsl", { query: "?raw", import: "default", eager: true }),
  ).map(([path, text]) => [path.slice("./textbook/".length, -".wgsl".length), text]),
);

/**
 * Rays from a scene's own origin, `camera.target`, each with what it does after its first hit: it leaves on the side it came
 * from, with local direction `wi`.
 */
export class Rays {
  readonly values: Float32Array;
  readonly count: number;

  constructor(count: number) {
    this.count = count;
    this.values = new Float32Array(12 * count);
  }

  set(i: number, o: Vec3, d: Vec3, wi: Vec3 = [0, 0, 1]): void {
    this.values.set(o, 12 * i);
    this.values.set(d, 12 * i + 4);
    this.values.set(wi, 12 * i + 8);
  }

  /** As the device gets them. */
  origin(i: number): Vec3 {
    return this.#vector(12 * i);
  }

  direction(i: number): Vec3 {
    return this.#vector(12 * i + 4);
  }

  #vector(at: number): Vec3 {
    return [this.values[at]!, this.values[at + 1]!, this.values[at + 2]!];
  }
}

/** What rays met: ids of primitives, or of triangles of meshes by their slot after the primitives; NONE for nothing, and distances; per ray, in order. */
export type Traced = {
  readonly id: Uint32Array;
  readonly t: Float32Array;
  /** Where the ray left, and from which side of which primitive. */
  readonly p: (i: number) => Vec3;
  readonly source: Uint32Array;
  readonly nextDirection: (i: number) => Vec3;
  readonly nextId: Uint32Array;
  readonly nextT: Float32Array;
};

/** Traces rays, two segments each, through a compiled scene on the device. */
export async function traceRays(scene: Scene, rays: Rays, method: Method = "ours"): Promise<Traced> {
  const resolved = parseScene(scene);
  const settings = { estimator: "path", sampler: "sobol", lightSamples: 1 } as const;
  const geometry = await prepareGeometry(resolved);
  const { sceneModule, features, uniform, isStored } = compileScene(resolved, settings, undefined, geometry);
  const isOurs = method === "ours";
  const words = await runProbe({
    wgsl: `
      import package::constants::NONE;
      import package::basis::toWorld;
      import package::ray::makeRay;
      import package::scene::closestHit;
      import package::surface::surfaceAt;
      fn probe(i: u32) {
        let ray = makeRay(bitcast<vec4f>(inputs[3u * i]).xyz, bitcast<vec4f>(inputs[3u * i + 1u]).xyz, NONE);
        let hit = closestHit(ray);
        outputs[3u * i] = vec4u(hit.id, bitcast<u32>(hit.t), NONE, 0u);
        if (hit.id == NONE) { return; }
        let surface = surfaceAt(ray, hit);
        let p = ${isOurs ? "surface.p" : "ray.o + hit.t * ray.d"};
        let wi = normalize(toWorld(surface.frame, bitcast<vec4f>(inputs[3u * i + 2u]).xyz));
        let next = closestHit(makeRay(p, wi, surface.source));
        outputs[3u * i] = vec4u(hit.id, bitcast<u32>(hit.t), next.id, bitcast<u32>(next.t));
        outputs[3u * i + 1u] = vec4u(bitcast<vec3u>(p), surface.source);
        outputs[3u * i + 2u] = vec4u(bitcast<vec3u>(wi), 0u);
      }`,
    conditions: features,
    modules: { ...(isOurs ? {} : TEXTBOOK), scene: sceneModule },
    scene: uniform,
    geometry,
    isStored,
    count: rays.count,
    inputs: rays.values,
    outputRows: 3 * rays.count,
  });
  const floats = new Float32Array(words.buffer);
  const column = (offset: number) => Uint32Array.from({ length: rays.count }, (_, i) => words[12 * i + offset]!);
  const vector = (at: number): Vec3 => [floats[at]!, floats[at + 1]!, floats[at + 2]!];
  return {
    id: column(0),
    t: new Float32Array(column(1).buffer),
    nextId: column(2),
    nextT: new Float32Array(column(3).buffer),
    p: (i) => vector(12 * i + 4),
    source: column(7),
    nextDirection: (i) => vector(12 * i + 8),
  };
}

/** How many indices below `count` satisfy a condition. */
export function tally(count: number, holds: (i: number) => boolean): number {
  let sum = 0;
  for (let i = 0; i < count; i++) if (holds(i)) sum++;
  return sum;
}
