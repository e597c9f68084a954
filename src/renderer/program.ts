import type { CompiledScene } from "../compile/compileScene";
import { linkProgram } from "../compile/linkProgram";
import { createTracePipelines, type TracePipelines } from "../gpu/tracePass";

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
