import { describe, expect, test } from "vitest";
import { chooseSample, SAMPLE, type Sample } from "../../../src/bvh/sample";
import { createSlots, PRIMITIVE_WORD, quantize, WORDS } from "../../../src/bvh/slots";
import { boxSoup } from "../../support/bvh";
import { createRandom } from "../../support/random";

/** The primitives chosen of all: those that stand for others, and those that stand for themselves. */
function choose(bounds: Float32Array, isCalm: boolean): { others: number[]; notable: number[]; sample: Sample } {
  const count = bounds.length / 6;
  const [from, to] = [createSlots(count), createSlots(count)];
  for (let slot = 0; slot < count; slot++) from.words[WORDS * slot + PRIMITIVE_WORD] = slot;
  quantize(from, 0, count, bounds);
  const sample: Sample = { others: 0, weight: 0, notable: 0, calmLevels: 0 };
  chooseSample(from, to, 0, count, isCalm, sample);
  const chosen = Array.from(
    { length: sample.others + sample.notable },
    (_, slot) => to.words[WORDS * slot + PRIMITIVE_WORD]!,
  );
  return { others: chosen.slice(0, sample.others), notable: chosen.slice(sample.others), sample };
}

describe("the sample of a large node", () => {
  const COUNT = 20_000;
  const small = () => boxSoup(createRandom(9), COUNT, 0.004);

  test("is of different primitives, each for as many, and small ones everywhere are calm, seed 9", () => {
    const { others, notable, sample } = choose(small(), false);
    expect(new Set(others).size).toBe(others.length);
    expect(others.length).toBeGreaterThan(SAMPLE * 0.9);
    expect(others.length * sample.weight).toBeGreaterThan(COUNT * 0.9);
    expect(notable).toEqual([]);
    // A sixteenth of the range is 31 times the largest: four halvings, of three levels each, less one.
    expect(sample.calmLevels).toBe(11);
  });

  test("has every one that is huge or far out, once, seed 9", () => {
    const bounds = small();
    bounds.set([0.1, 0.5, 0.1, 0.9, 0.5, 0.9], 6 * 77); // a floor
    bounds.set([5, 5, 5, 5, 5, 5], 6 * 7001); // a point far out
    bounds.set([0.2, 0, 0.3, 0.2, 1, 0.3], 6 * 19_999); // a pole
    const { others, notable, sample } = choose(bounds, false);
    expect(notable).toEqual([77, 7001, 19_999]);
    expect(others).not.toContain(77);
    expect(sample.calmLevels).toBe(0);
  });

  test("does not look for them where there can be none", () => {
    expect(choose(small(), true).sample.notable).toBe(0);
  });
});
