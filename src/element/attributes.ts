import { type NumberRange, SETTING_RANGES } from "../renderer/checkSettings";

/** The attributes that are settings of the tracer, by the name of the setting, and what they may be. */
export const SETTING_ATTRIBUTES = {
  maxBounces: { attribute: "max-bounces", ...SETTING_RANGES.maxBounces },
  samplesPerFrame: { attribute: "samples-per-frame", ...SETTING_RANGES.samplesPerFrame },
  lightSamples: { attribute: "light-samples", ...SETTING_RANGES.lightSamples },
  targetError: { attribute: "target-error", ...SETTING_RANGES.targetError },
  maxSamples: { attribute: "max-samples", ...SETTING_RANGES.maxSamples },
} as const;

/** A setting that has an attribute. */
export type SettingName = keyof typeof SETTING_ATTRIBUTES;

export const SETTING_NAMES = Object.keys(SETTING_ATTRIBUTES) as readonly SettingName[];

/** Stops; 2^±32 is more than any display or scene spans, and keeps the product finite. */
export const EXPOSURE_RULE: NumberRange = { min: -32, max: 32, isInteger: false };

/** When the scene is fetched: at once, or when the element is less than a screen away from what is seen of the page. */
export const LOADING_MODES = ["eager", "lazy"] as const;

export type LoadingMode = (typeof LOADING_MODES)[number];

/** Every attribute the element reacts to. */
export const OBSERVED_ATTRIBUTES: readonly string[] = [
  "src",
  "controls",
  "drop",
  "stats",
  "paused",
  "alt",
  "poster",
  "loading",
  "exposure",
  "tone-map",
  "camera-orbit",
  ...SETTING_NAMES.map((name) => SETTING_ATTRIBUTES[name].attribute),
];

/** The setting an attribute stands for, if any. */
export function settingOfAttribute(attribute: string): SettingName | undefined {
  return SETTING_NAMES.find((name) => SETTING_ATTRIBUTES[name].attribute === attribute);
}

/** Reads one of a few words, whatever its case. An absent or other one is the fallback. */
export function parseKeyword<T extends string>(text: string | null, words: readonly T[], fallback: T): T {
  const wanted = text?.trim().toLowerCase();
  return words.find((word) => word === wanted) ?? fallback;
}

/**
 * Reads a number as HTML does, forgivingly: an absent, malformed or out-of-range value is `undefined` and the default
 * applies.
 */
export function parseNumber(text: string | null, rule: NumberRange): number | undefined {
  if (text === null || text.trim() === "") return undefined;
  const value = Number(text);
  if (!(value >= rule.min && value <= rule.max)) return undefined;
  if (rule.isInteger && !Number.isInteger(value) && value !== Number.POSITIVE_INFINITY) return undefined;
  return value;
}
