import { mkdirSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const FOLDER = fileURLToPath(new URL("../../output/", import.meta.url));

/** Leaves what a test measured in `tests/output/NAME.json`, and says it. */
export function report(name: string, figures: Readonly<Record<string, unknown>>): void {
  mkdirSync(FOLDER, { recursive: true });
  writeFileSync(`${FOLDER}${name}.json`, `${JSON.stringify(figures, undefined, 2)}\n`);
  console.log(`${name}: ${JSON.stringify(figures)}`);
}
