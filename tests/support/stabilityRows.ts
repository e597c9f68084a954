import { mkdirSync, writeFileSync } from "node:fs";

/** One line of the stability report. */
export type StabilityRow = {
  /** The hard case, in words. */
  readonly case: string;
  /** What the test asserts. */
  readonly asserted: string;
  /** How many inputs were tried. */
  readonly inputs: number;
  /** The worst error found: relative, unless `asserted` says otherwise. */
  readonly worst: number | string;
  /** The same of the textbook formula; undefined where there is no other. */
  readonly textbook?: number | string;
};

const FOLDER = new URL("../output/stability/", import.meta.url);

/** Leaves rows for the stability report, which puts the files together in the order of their names. */
export function recordStability(name: string, rows: readonly StabilityRow[]): void {
  mkdirSync(FOLDER, { recursive: true });
  writeFileSync(new URL(`${name}.json`, FOLDER), `${JSON.stringify(rows, finite, 2)}\n`);
}

/** JSON has no infinities and no NaN. */
function finite(_: string, value: unknown): unknown {
  return typeof value === "number" && !Number.isFinite(value) ? String(value) : value;
}
