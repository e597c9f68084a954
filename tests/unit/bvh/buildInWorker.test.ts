import { describe, expect, test } from "vitest";
import { buildBvh } from "../../../src/bvh/buildBvh";
import { buildBvhAsync, MIN_WORKER_PRIMITIVES } from "../../../src/bvh/buildInWorker";
import { boxSoup } from "../../support/bvh";
import { createRandom } from "../../support/random";

// Node has no Worker: these build in the thread, whatever the size.
describe("building asynchronously, without a worker", () => {
  test.each([100, MIN_WORKER_PRIMITIVES + 1])("gives the tree of buildBvh, of %i primitives", async (count) => {
    const bounds = boxSoup(createRandom(1), count);
    const fractions: number[] = [];
    const bvh = await buildBvhAsync(bounds, { maxLeaf: 2, onProgress: (fraction) => fractions.push(fraction) });
    expect(bvh).toEqual(buildBvh(bounds, { maxLeaf: 2 }));
    expect(fractions.at(-1)).toBe(1);
  });

  test("rejects with what buildBvh throws", async () => {
    await expect(buildBvhAsync(Float32Array.of(0, 0, 0, 1, 1, Number.NaN))).rejects.toThrow(RangeError);
  });

  test("rejects with the reason of a signal that is aborted", async () => {
    const reason = new Error("no longer needed");
    await expect(buildBvhAsync(new Float32Array(6), { signal: AbortSignal.abort(reason) })).rejects.toBe(reason);
  });
});
