import { type CompiledScene, compileScene } from "../compile/compileScene";
import type { ProgramSettings } from "../compile/features";
import { linkProgram } from "../compile/linkProgram";
import { createTracePipelines, type TracePipelines } from "../gpu/tracePass";
import type { ResolvedCamera, ResolvedScene } from "../scene/schema";
import type { Geometry } from "../tree/geometry";

/** A compiled tracer for every scene that needs the same features in the same places. */
export type Program = {
  readonly wgsl: string;
  /** What it contains, in words. */
  readonly features: readonly string[];
  readonly compileSeconds: number;
  readonly pipelines: TracePipelines;
  /** Programs with equal keys are interchangeable. */
  readonly key: string;
};

/** Compiles a scene for a camera that need not be its own. */
export function compileFor(
  { scene, camera }: { readonly scene: ResolvedScene; readonly camera: ResolvedCamera },
  settings: ProgramSettings,
  geometry: Geometry | undefined,
): CompiledScene {
  return compileScene(scene, settings, undefined, geometry, camera);
}

/** What decides whether a program fits a scene: all generated text, and the conditions it is linked under. */
export function programKey({ sceneModule, features }: CompiledScene): string {
  return JSON.stringify(features) + sceneModule;
}

/** @throws {WebGpuError} with the compiler's messages; that is a bug of ours, whatever the scene. */
export async function createProgram(device: GPUDevice, compiled: CompiledScene): Promise<Program> {
  const start = performance.now();
  const wgsl = await linkProgram(compiled.sceneModule, compiled.features);
  const pipelines = await createTracePipelines(device, wgsl, compiled);
  const compileSeconds = (performance.now() - start) / 1000;
  return { wgsl, features: compiled.description, compileSeconds, pipelines, key: programKey(compiled) };
}
