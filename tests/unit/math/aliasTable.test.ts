import { expect, test } from "vitest";
import { aliasTable } from "../../../src/math/aliasTable";
import { createRandom } from "../../support/random";

/** How often each entry is chosen, by the table. */
function shares(weights: Float64Array): number[] {
  const { probability, alias } = aliasTable(weights);
  const chosen = new Array<number>(weights.length).fill(0);
  for (let i = 0; i < weights.length; i++) {
    chosen[i]! += probability[i]! / weights.length;
    chosen[alias[i]!]! += (1 - probability[i]!) / weights.length;
  }
  return chosen;
}

test.each([
  ["one", [3]],
  ["even", [1, 1, 1, 1]],
  ["uneven", [1, 2, 3, 10, 0.5]],
  ["some of nothing", [0, 4, 0, 1, 0]],
  ["a thousand, seed 1", Array.from({ length: 1000 }, createRandom(1)).map((x) => x ** 8)],
])("%s are chosen in proportion to their weights", (_, weights) => {
  const total = weights.reduce((sum, weight) => sum + weight, 0);
  for (const [i, share] of shares(Float64Array.from(weights)).entries()) {
    // A thousand additions of doubles.
    expect(Math.abs(share - weights[i]! / total)).toBeLessThan(1e-13);
    if (weights[i] === 0) expect(share).toBe(0);
  }
});
