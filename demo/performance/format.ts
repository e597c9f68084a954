const PREFIXES = ["", " k", " M", " G", " T"];

/** Three significant digits, without an exponent. */
export function digits(value: number): string {
  if (!Number.isFinite(value)) return "–";
  const exponent = value === 0 ? 0 : Number(value.toExponential(2).split("e")[1]);
  return value.toFixed(Math.min(6, Math.max(0, 2 - exponent)));
}

/** `1234567` → `"1.23 M"`. */
export function shortNumber(value: number): string {
  if (!Number.isFinite(value)) return "–";
  const exponent = value === 0 ? 0 : Number(value.toExponential(2).split("e")[1]);
  const tier = Math.min(PREFIXES.length - 1, Math.max(0, Math.floor(exponent / 3)));
  return `${digits(value / 1000 ** tier)}${PREFIXES[tier]}`;
}

/** `0.0123` → `"1.23 %"`. */
export function percent(ratio: number | undefined): string {
  return ratio === undefined || !Number.isFinite(ratio) ? "–" : `${digits(ratio * 100)} %`;
}

/** `12345` → `"12,345"`. */
export function count(value: number): string {
  return value.toLocaleString("en");
}

/** A time as people say it: `"0.54 s"`, `"18 ms"`. */
export function duration(seconds: number): string {
  if (seconds >= 10) return `${seconds.toFixed(1)} s`;
  return seconds >= 0.1 ? `${seconds.toFixed(2)} s` : `${(seconds * 1000).toFixed(seconds < 0.01 ? 1 : 0)} ms`;
}

/** How many times: `"3.4×"`, `"37×"`. */
export function times(factor: number): string {
  return `${factor < 10 ? factor.toFixed(1) : Math.round(factor).toLocaleString("en")}×`;
}
