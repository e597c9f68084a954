import { linkModule } from "../compile/linkProgram";
import { requestDevice } from "../gpu/device";
import { checkFilmSize } from "../gpu/film";
import { createComputePipeline } from "../gpu/pipelines";
import { parseScene } from "../scene/parseScene";
import type { Scene } from "../scene/schema";
import { buildGeometry } from "./buildGeometry";
import { checkSettings } from "./checkSettings";
import { DeviceGuard } from "./deviceGuard";
import { cameraFor, type ReadyScene, type SceneOptions } from "./installation";
import { compileFor, createProgram } from "./program";
import { DEFAULT_SETTINGS, type Settings } from "./settings";

/** What a tracer is made from. */
export type PathTracerOptions = {
  readonly scene: Scene;
  /** In pixels. */
  readonly width: number;
  readonly height: number;
  /** Used, never destroyed. Without one the tracer requests its own and destroys it with itself. */
  readonly device?: GPUDevice;
  readonly settings?: Partial<Settings>;
} & SceneOptions;

/** What a tracer is put together from, once all that takes time is done. */
export type TracerParts = {
  readonly guard: DeviceGuard;
  readonly settings: Settings;
  readonly first: ReadyScene;
  readonly errorPipeline: GPUComputePipeline;
  readonly width: number;
  readonly height: number;
};

/**
 * Checks, sorts and compiles. What is wrong with the scene or the settings is told before a device is asked for.
 *
 * @returns parts of which the guard is to be disposed of.
 * @throws as `PathTracer.create` does.
 */
export async function createParts(options: PathTracerOptions): Promise<TracerParts> {
  const settings = { ...DEFAULT_SETTINGS, ...options.settings };
  const scene = parseScene(options.scene);
  checkSettings(settings, scene.maxBounces);
  const camera = cameraFor(scene, options);
  const geometry = await buildGeometry(scene, options);
  const compiled = compileFor({ scene, camera }, settings, geometry?.source);

  const { width, height, device = await requestDevice() } = options;
  const guard = new DeviceGuard(device, options.device === undefined);
  try {
    checkFilmSize(device, width, height);
    const [program, errorPipeline] = await Promise.all([createProgram(device, compiled), createErrorPipeline(device)]);
    const first = { scene, camera, compiled, program, geometry };
    return { guard, settings, first, errorPipeline, width, height };
  } catch (error) {
    guard.dispose();
    throw error;
  }
}

async function createErrorPipeline(device: GPUDevice): Promise<GPUComputePipeline> {
  return createComputePipeline(device, "error", await linkModule("error"), "sumErrors");
}
