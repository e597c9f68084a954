import { RtViewerError } from "../errors";
import type { Settings } from "./settings";

/** Numbers from `min` to `max`. */
export type NumberRange = { readonly min: number; readonly max: number; readonly isInteger: boolean };

/** What the settings that are numbers may be. */
export const SETTING_RANGES = {
  maxBounces: { min: 0, max: 1024, isInteger: true },
  samplesPerFrame: { min: 1, max: 1024, isInteger: true },
  lightSamples: { min: 1, max: 1024, isInteger: true },
  seed: { min: 0, max: 2 ** 32 - 1, isInteger: true },
  targetError: { min: 0, max: Number.MAX_VALUE, isInteger: false },
  maxSamples: { min: 1, max: Number.POSITIVE_INFINITY, isInteger: true },
} as const satisfies { readonly [K in keyof Settings]?: NumberRange };

const CHOICES = {
  estimator: ["path", "uniform"],
  sampler: ["sobol", "independent"],
  constants: [true, false, "auto"],
} as const satisfies { readonly [K in keyof Settings]?: readonly Settings[K][] };

// One path can't be cut into several submits: with more shadow rays in it, four of them would keep a software adapter busy for
// more than the 50 ms that a page can spare.
const MOST_SHADOW_RAYS = 16_400;

/**
 * @param sceneBounces - the scene's `maxBounces`.
 * @throws {RtViewerError} that names each setting that no picture can be made with, what it is and what it may be.
 */
export function checkSettings(settings: Settings, sceneBounces: number): void {
  const issues = [
    ...Object.entries(SETTING_RANGES).flatMap(([name, range]) => {
      const value = settings[name as keyof Settings];
      if (value === undefined || (name === "samplesPerFrame" && value === "auto") || isWithin(value, range)) return [];
      const kind = range.isInteger ? "an integer" : "a number";
      const limits = range.max < Number.MAX_VALUE ? `from ${range.min} to ${range.max}` : `≥ ${range.min}`;
      return [`${name}: expected ${kind} ${limits}, got ${String(value)}`];
    }),
    ...Object.entries(CHOICES).flatMap(([name, choices]) => {
      const value = settings[name as keyof Settings];
      if (choices.some((choice) => choice === value)) return [];
      return [
        `${name}: expected ${choices.map((choice) => JSON.stringify(choice)).join(" or ")}, got ${String(value)}`,
      ];
    }),
  ];
  const { lightSamples, maxBounces = sceneBounces } = settings;
  if (issues.length === 0 && lightSamples * (maxBounces + 1) > MOST_SHADOW_RAYS) {
    const most = Math.floor(MOST_SHADOW_RAYS / (maxBounces + 1));
    issues.push(`lightSamples: at most ${most} are possible with ${maxBounces} bounces, got ${lightSamples}`);
  }
  if (issues.length > 0) throw new RtViewerError(`The settings can't be used:\n${issues.join("\n")}`);
}

function isWithin(value: unknown, { min, max, isInteger }: NumberRange): boolean {
  if (typeof value !== "number" || !(value >= min && value <= max)) return false;
  return !isInteger || Number.isInteger(value) || value === Number.POSITIVE_INFINITY;
}
