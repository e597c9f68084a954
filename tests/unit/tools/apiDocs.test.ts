import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { afterAll, beforeAll, expect, test } from "vitest";
import { describeEntry, type Export, readExports } from "../../../tools/apiDocs";

const FILES = {
  "index.d.ts": `
    import { Local } from "./local.js";
    export { Local as Renamed };
    export type { Size } from "./local.js";
    export * from "./functions.js";
    declare global { interface Window {} }`,
  "local.d.ts": `
/** Not exported by the entry. */
export declare const hidden: number;
/** In pixels. */
export type Size = {
    /** > 0 */
    readonly width: number;
};
/** Owns something. */
export declare class Local {
    #private;
    private constructor();
    /** How large it is. */
    get size(): Size;
}`,
  "functions.d.ts": `
/**
 * Doubles a number.
 *
 * @param x - any number.
 * @returns twice as much.
 * @throws {RangeError} if that is infinite.
 */
export declare function twice(x: number): number;`,
};

let folder: string;
let exports: readonly Export[];
beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), "rt-viewer-docs-"));
  for (const [name, text] of Object.entries(FILES)) await writeFile(join(folder, name), text);
  exports = await readExports(pathToFileURL(join(folder, "index.d.ts")));
});
afterAll(() => rm(folder, { recursive: true }));

test("what an entry exports is found, wherever it is declared and whatever it is called there", () => {
  expect(exports.map(({ name }) => name)).toEqual(["Renamed", "Size", "twice"]);
});

test("a page has docstrings and declarations, without what is private", () => {
  expect(describeEntry("the-entry", exports, ["before"])).toBe(
    [
      "# the-entry",
      "before",
      "## Renamed",
      "Owns something.",
      "```ts\nclass Local {\n  /** How large it is. */\n  get size(): Size;\n}\n```",
      "## Size",
      "In pixels.",
      "```ts\ntype Size = {\n  /** > 0 */\n  readonly width: number;\n};\n```",
      "## twice",
      "Doubles a number.",
      "- `x`: any number.\n- returns twice as much.\n- throws `RangeError` if that is infinite.",
      "```ts\nfunction twice(x: number): number;\n```",
    ].join("\n\n"),
  );
});

test("a name that is nowhere is an error", async () => {
  await writeFile(join(folder, "broken.d.ts"), `export { gone } from "./local.js";`);
  await expect(readExports(pathToFileURL(join(folder, "broken.d.ts")))).rejects.toThrow(
    'gone, which is not in "./local.js"',
  );
});
