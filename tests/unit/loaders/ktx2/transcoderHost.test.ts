import { expect, test } from "vitest";
import { IMPORT_NAMES } from "../../../../src/loaders/ktx2/transcoderHost";
import { readBasisScript } from "../../../support/basisScript";

test("the module's imports are named as in the script that comes with it", async () => {
  const [, table] = /var wasmImports=\{(.*?)\}/.exec(await readBasisScript())!;
  const pairs = table!.split(",").map((pair) => pair.split(":") as [string, string]);
  // The script calls a function of C by its name with one underscore before it.
  const names = Object.fromEntries(pairs.map(([letter, name]) => [letter, name.slice(1)]));
  expect(IMPORT_NAMES).toEqual(names);
});
