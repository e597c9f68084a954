import { describe, expect, test } from "vitest";
import { buildBvh } from "../../../src/bvh/buildBvh";
import { packTree } from "../../../src/compile/packTree";
import { createRandom } from "../../support/random";

const LEAF = 0x80000000;

/** Boxes anywhere in the unit cube. */
function boxes(count: number, seed: number): Float32Array {
  const random = createRandom(seed);
  const bounds = new Float32Array(6 * count);
  for (let i = 0; i < count; i++) {
    for (let axis = 0; axis < 3; axis++) {
      const lower = random();
      bounds[6 * i + axis] = lower;
      bounds[6 * i + 3 + axis] = lower + 0.1 * random();
    }
  }
  return bounds;
}

/** Walks all that a ray could, and returns the slots of the leaves; checks that boxes hold what is below them. */
function walk(buffer: ArrayBuffer, boundsOfSlot: (slot: number) => number[]): { slots: number[]; depth: number } {
  const [floats, words] = [new Float32Array(buffer), new Uint32Array(buffer)];
  const slots: number[] = [];
  let deepest = 0;
  const visit = (link: number, depth: number, held: readonly number[][]) => {
    deepest = Math.max(deepest, depth);
    if (link >= LEAF) {
      const [count, first] = [(link >>> 27) & 15, link & 0x07ffffff];
      for (let slot = first; slot < first + count; slot++) {
        slots.push(slot);
        const own = boundsOfSlot(slot);
        for (const box of held) {
          for (let axis = 0; axis < 3; axis++) {
            expect(box[axis]).toBeLessThanOrEqual(own[axis]!);
            expect(box[3 + axis]).toBeGreaterThanOrEqual(own[3 + axis]!);
          }
        }
      }
      return;
    }
    const at = 16 * link;
    const box = (offset: number) => [
      ...floats.subarray(at + offset, at + offset + 3),
      ...floats.subarray(at + offset + 4, at + offset + 7),
    ];
    visit(words[at + 3]!, depth + 1, [...held, box(0)]);
    visit(words[at + 7]!, depth + 1, [...held, box(8)]);
  };
  visit(0, 0, []);
  return { slots, depth: deepest };
}

describe.each([1, 2, 3, 1000])("%d boxes, seed 1", (count) => {
  test("every slot is in one leaf, and in every box above it", () => {
    const bounds = boxes(count, 1);
    const bvh = buildBvh(bounds, { maxLeaf: 2 });
    const boundsOfSlot = (slot: number) => {
      const primitive = bvh.order[slot]!;
      return [...bounds.subarray(6 * primitive, 6 * primitive + 6)];
    };
    const { slots, depth } = walk(packTree(bvh), boundsOfSlot);
    expect(slots.sort((a, b) => a - b)).toEqual(Array.from({ length: count }, (_, slot) => slot));
    // A tree of one leaf gets a node above it.
    expect(depth).toBe(Math.max(bvh.depth, 1));
  });
});

test("nothing is a node that leads nowhere", () => {
  const { slots } = walk(packTree(buildBvh(new Float32Array(0))), () => []);
  expect(slots).toEqual([]);
});
