import { describe, expect, test } from "vitest";
import { buildBvh } from "../../../src/bvh/buildBvh";
import { packTree } from "../../../src/tree/packTree";
import { createRandom } from "../../support/random";

const NODE_WORDS = 8;

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

type Child = { readonly count: number; readonly place: number; readonly box: readonly number[] };

/** The children of a node, as `wgsl/tree.wgsl` decodes them. */
function childrenOf(buffer: ArrayBuffer, node: number): [Child, Child] {
  const at = NODE_WORDS * node;
  const [floats, words] = [new Float32Array(buffer), new Uint32Array(buffer)];
  const [place, shape] = [words[at + 3]!, words[at + 7]!];
  const [count0, count1] = [shape & 7, (shape >>> 3) & 7];
  const child = (i: 0 | 1, count: number, childPlace: number): Child => {
    const span = (axis: number, sign: number) => {
      const step = 2 ** (((shape >>> (7 + 8 * axis)) & 0xff) - 127);
      const bytes = (words[at + 4 + axis]! >>> (16 * i)) & 0xffff;
      const middle = i === 0 ? bytes >>> 8 : ((bytes << 16) >> 24) + 128;
      return floats[at + axis]! + step * (middle + (sign * (bytes & 0xff)) / 2);
    };
    return {
      count,
      place: childPlace,
      box: [0, 1, 2].map((a) => span(a, -1)).concat([0, 1, 2].map((a) => span(a, 1))),
    };
  };
  const secondPlace = count1 > 0 ? place + count0 : count0 > 0 ? node + 1 : place;
  return [child(0, count0, count0 > 0 ? place : node + 1), child(1, count1, secondPlace)];
}

/** Walks all that a ray could, and returns the slots of the leaves; checks that boxes hold what is below them. */
function walk(buffer: ArrayBuffer, boundsOfSlot: (slot: number) => number[]): { slots: number[]; depth: number } {
  const slots: number[] = [];
  let deepest = 0;
  const visit = (node: number, depth: number, held: readonly (readonly number[])[]) => {
    for (const { count, place, box } of childrenOf(buffer, node)) {
      const boxes = [...held, box];
      if (count === 0) {
        if (!isNowhere(buffer, place)) visit(place, depth + 1, boxes);
        continue;
      }
      deepest = Math.max(deepest, depth + 1);
      for (let slot = place; slot < place + count; slot++) {
        slots.push(slot);
        const own = boundsOfSlot(slot);
        for (const outer of boxes) {
          for (let axis = 0; axis < 3; axis++) {
            expect(outer[axis]).toBeLessThanOrEqual(own[axis]!);
            expect(outer[3 + axis]).toBeGreaterThanOrEqual(own[3 + axis]!);
          }
        }
      }
    }
  };
  if (!isNowhere(buffer, 0)) visit(0, 0, []);
  return { slots, depth: deepest };
}

function isNowhere(buffer: ArrayBuffer, node: number): boolean {
  return new Float32Array(buffer)[NODE_WORDS * node] === Math.fround(1e18);
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

test("boxes grow by less than 4 %, 1000 of them, seed 1", () => {
  const bvh = buildBvh(boxes(1000, 1), { maxLeaf: 2 });
  const nodes = packTree(bvh);
  const areaOf = (box: ArrayLike<number>) => {
    const [x, y, z] = [0, 1, 2].map((axis) => box[3 + axis]! - box[axis]!) as [number, number, number];
    return x * y + y * z + z * x;
  };
  let [packed, exact] = [0, 0];
  for (let node = 0, inner = 0; node < bvh.axes.length; node++) {
    if (bvh.axes[node] === 3) continue;
    const children = childrenOf(nodes, inner++);
    for (const [i, child] of [node + 1, bvh.links[node]!].entries()) {
      packed += areaOf(children[i]!.box);
      exact += areaOf(bvh.bounds.subarray(6 * child, 6 * child + 6));
    }
  }
  expect(packed / exact).toBeGreaterThan(1);
  expect(packed / exact).toBeLessThan(1.04);
});
