import type { CompiledScene } from "../compile/compileScene";
import { linkProgram } from "../compile/linkProgram";
import { explainFailure } from "../gpu/device";
import { createPickPipeline, type PickPipeline, runPick } from "../gpu/pickPass";
import type { SceneGeometry } from "../gpu/sceneGeometry";
import { add, normalize, scale } from "../math/vec3";
import { partOf, type ScenePart } from "../scene/parts";
import type { ResolvedCamera, ResolvedScene, Vec3 } from "../scene/schema";
import { cameraBasis, rayStart } from "./cameraBasis";
import { programKey } from "./program";

/** What is seen at a point of the picture. */
export type Picked = ScenePart & {
  /** From where the ray starts, in metres: the camera's position or, of an orthographic one, a point beside it. */
  readonly distance: number;
  /** The point itself, in the scene's coordinates. */
  readonly position: Vec3;
};

/** What a picture shows. */
export type Sight = {
  readonly scene: ResolvedScene;
  readonly compiled: CompiledScene;
  readonly geometry: SceneGeometry | undefined;
  readonly camera: ResolvedCamera;
  /** In pixels. */
  readonly width: number;
  readonly height: number;
};

/**
 * Finds out what is seen at a point, by the scene's own intersection code. That is compiled with the first question, and
 * again when a scene needs other code.
 */
export class Picker {
  readonly #device: GPUDevice;
  #key: string | undefined;
  #pipeline: Promise<PickPipeline> | undefined;
  #isDisposed = false;

  constructor(device: GPUDevice) {
    this.#device = device;
  }

  /**
   * @param sight - asked when the answer is sought: it may change while the code is compiled.
   * @param x - in pixels from the left edge.
   * @param y - from the upper edge.
   * @returns `undefined` where there is nothing, outside of the picture, and after `dispose()`.
   * @throws {WebGpuError} if the code does not compile, or the device fails.
   */
  async pick(sight: () => Sight, x: number, y: number): Promise<Picked | undefined> {
    const { width, height } = sight();
    const isInside = x >= 0 && x <= width && y >= 0 && y <= height;
    if (!isInside || this.#isDisposed) return undefined;
    try {
      return await this.#trace(sight, (2 * x) / width - 1, 1 - (2 * y) / height);
    } catch (error) {
      if (this.#isDisposed) return undefined; // and the device perhaps with it
      throw await explainFailure(this.#device, error);
    }
  }

  dispose(): void {
    this.#isDisposed = true;
  }

  /** By coordinates in the image plane, from -1 to 1. */
  async #trace(sight: () => Sight, x: number, y: number): Promise<Picked | undefined> {
    const key = programKey(sight().compiled);
    const pipeline = await this.#pipelineFor(sight().compiled);
    await sight().geometry?.filling;
    if (this.#isDisposed) return undefined;
    const { scene, compiled, geometry, camera, width, height } = sight();
    if (programKey(compiled) !== key || geometry?.filling) return this.#trace(sight, x, y);
    const { origin, forward, right, up, isOrthographic } = cameraBasis(
      camera,
      compiled.origin,
      width / height,
      compiled.unit,
    );
    const offset = add(scale(right, x), scale(up, y));
    const direction = isOrthographic ? forward : normalize(add(forward, offset));
    const from: Vec3 = isOrthographic ? offset : [0, 0, 0];
    // A picture of one pixel, with the point in its middle.
    const narrow = { origin: add(origin, from), forward: direction, right: [0, 0, 0], up: [0, 0, 0] } as const;
    const start = rayStart(narrow, compiled.shapes);
    const found = await runPick(this.#device, pipeline, compiled.uniform, geometry, { ...ONE_PIXEL, ...start });
    if (found === undefined) return undefined;
    const way = add(from, scale(direction, start.near + found.t));
    return {
      ...partOf(scene, found.id),
      distance: (start.near + found.t) * compiled.unit,
      position: add(camera.position, scale(way, compiled.unit)),
    };
  }

  #pipelineFor(compiled: CompiledScene): Promise<PickPipeline> {
    const key = programKey(compiled);
    if (this.#pipeline === undefined || key !== this.#key) {
      this.#key = key;
      this.#pipeline = linkProgram(compiled.sceneModule, compiled.features, "pick").then((wgsl) =>
        createPickPipeline(this.#device, wgsl, compiled),
      );
    }
    return this.#pipeline;
  }
}

const ONE_PIXEL = {
  size: [1, 1],
  firstStrip: 0,
  endStrip: 1,
  unitStrips: 1,
  unitStride: 1,
  half: 0,
  firstSample: 0,
  sampleCount: 1,
  seed: 0,
  maxBounces: 0,
  lightSamples: 1,
  emittersFrom: [0, 0],
  emittersTo: [0, 0],
} as const;
