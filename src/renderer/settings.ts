import type { ProgramSettings } from "../compile/features";

/** How the scene is sampled. Every field can change while the tracer runs. */
export type Settings = {
  /** How often a path may scatter between camera and light; 0 shows emitters only. Default: the scene's `maxBounces`. */
  readonly maxBounces: number | undefined;
  /** Light points sampled at each hit. Default 1. */
  readonly lightSamples: number;
  /**
   * Samples per pixel taken between two presentations, as far as the frame budget allows. `"auto"`, the default: as many as
   * it allows.
   */
  readonly samplesPerFrame: number | "auto";
  /**
   * `"path"`, the default: importance sampling of lobes and lights, combined by multiple importance sampling.
   * `"uniform"`: uniform hemisphere directions and light points uniform on the emitter's surface; the same expectation,
   * much more noise. It is the yardstick of speed against error, not meant for pictures.
   */
  readonly estimator: "path" | "uniform";
  /** `"sobol"`, the default: Owen-scrambled Sobol points. `"independent"`: pseudo-random numbers (PCG). */
  readonly sampler: "sobol" | "independent";
  /**
   * Whether a scene at rest is compiled again, in the background, with its values as constants in the shader; the same image
   * up to rounding. `"auto"`, the default: both programs are timed, and the quicker one goes on.
   */
  readonly constants: boolean | "auto";
  /** Seed of the sampler, an unsigned 32-bit integer. The same seed gives the same image. Default 1. */
  readonly seed: number;
  /** Sampling stops once `stats.error` is at most this relative RMSE. Default 0: never. */
  readonly targetError: number;
  /**
   * Sampling stops after this many samples per pixel, or after 33,554,432 (2²⁵): their mean is as exact as the film's f32,
   * and more would change nothing that can be seen. Default `Infinity`.
   */
  readonly maxSamples: number;
};

/** What every setting is unless it is given. */
export const DEFAULT_SETTINGS: Settings = {
  maxBounces: undefined,
  lightSamples: 1,
  samplesPerFrame: "auto",
  estimator: "path",
  sampler: "sobol",
  constants: "auto",
  seed: 1,
  targetError: 0,
  maxSamples: Number.POSITIVE_INFINITY,
};

/**
 * What a change of a setting asks for: another program, and with it another picture; only another picture, whose accumulation
 * then starts anew; or neither.
 */
export type SettingEffect = "recompile" | "restart" | "none";

/** What each setting's change asks for. Those that the compiler reads ask for another program: the type sees to that. */
export const SETTING_EFFECTS = {
  maxBounces: "restart",
  lightSamples: "recompile",
  samplesPerFrame: "none",
  estimator: "recompile",
  sampler: "recompile",
  constants: "restart", // the program with constants is another one, compiled once the scene rests
  seed: "restart",
  targetError: "none",
  maxSamples: "none",
} as const satisfies {
  readonly [K in keyof Settings]: K extends keyof ProgramSettings ? "recompile" : Exclude<SettingEffect, "recompile">;
};

/** What the settings that differ ask for, all together. */
export function effectOfChange(before: Settings, after: Settings): SettingEffect {
  const names = Object.keys(SETTING_EFFECTS) as (keyof Settings)[];
  const effects = new Set(names.filter((name) => before[name] !== after[name]).map((name) => SETTING_EFFECTS[name]));
  return (["recompile", "restart"] as const).find((effect) => effects.has(effect)) ?? "none";
}

// What a film counts exactly: 2²⁴ samples in each of its halves, as far as an f32 counts one by one. Sample indices stay below
// that, and so does what they are multiplied into: nothing wraps that matters.
const MOST_SAMPLES = 2 ** 25;

/** Samples per pixel after which sampling rests, whatever the error. */
export function sampleLimit({ maxSamples }: Pick<Settings, "maxSamples">): number {
  return Math.min(maxSamples, MOST_SAMPLES);
}
