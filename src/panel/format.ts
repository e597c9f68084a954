// Figures as people read them: short, with a unit, and never wider than the panel.

const PREFIXES = ["", "k", "M", "G", "T"];

/** `1234567` → `"1.23 M"`: three significant digits and a prefix. */
export function formatCount(value: number): string {
  if (!Number.isFinite(value)) return "–";
  const tier = Math.min(PREFIXES.length - 1, Math.floor(Math.max(0, exponentOf(value)) / 3));
  const scaled = value / 1000 ** tier;
  return `${tier === 0 && Number.isInteger(value) ? value : digits(scaled)} ${PREFIXES[tier]}`.trimEnd();
}

/** A rate per second: `"1.23 M/s"`. */
export function formatRate(perSecond: number): string {
  if (!(perSecond > 0)) return "–";
  const text = formatCount(perSecond);
  return /[a-z]$/i.test(text) ? `${text}/s` : `${text} /s`;
}

/** A relative error as a percentage: `0.0123` → `"1.23 %"`. */
export function formatPercent(ratio: number): string {
  return Number.isFinite(ratio) ? `${digits(ratio * 100)} %` : "–";
}

/** Milliseconds: `"16.7 ms"`. */
export function formatMilliseconds(milliseconds: number): string {
  return milliseconds > 0 && Number.isFinite(milliseconds) ? `${digits(milliseconds)} ms` : "–";
}

/** Seconds, or what is longer: `"0.1 s"`, `"12 s"`, `"3 min"`, `"2 h"`. */
export function formatSeconds(seconds: number): string {
  if (!Number.isFinite(seconds)) return "–";
  if (seconds < 120) return `${Number(seconds.toPrecision(2))} s`;
  return seconds < 7200 ? `${Math.round(seconds / 60)} min` : `${Math.round(seconds / 3600)} h`;
}

/** Frames per second: `"59.9"`. */
export function formatFps(fps: number): string {
  return fps > 0 && Number.isFinite(fps) ? digits(fps) : "–";
}

/** Three significant digits, without an exponent for what a panel shows. */
function digits(value: number): string {
  if (value === 0) return "0";
  const decimals = Math.min(6, Math.max(0, 2 - exponentOf(value)));
  return value.toFixed(decimals);
}

/** Of the value rounded to three digits, so that 999.9 counts as 1000. */
function exponentOf(value: number): number {
  return value === 0 ? 0 : Number(value.toExponential(2).split("e")[1]);
}
