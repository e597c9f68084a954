import { MAX_DEPTH } from "../../src/bvh/buildBvh";
import type { Bvh } from "../../src/bvh/bvh";

/** Boxes around points that fill the unit cube. @param size - the boxes' largest extent. */
export function boxSoup(random: () => number, count: number, size = 0.1): Float32Array {
  const bounds = new Float32Array(6 * count);
  for (let i = 0; i < count; i++) {
    for (let axis = 0; axis < 3; axis++) {
      const low = random();
      bounds[6 * i + axis] = low;
      bounds[6 * i + 3 + axis] = low + size * random();
    }
  }
  return bounds;
}

/** What is wrong with a tree over these bounds, in words; nothing if it keeps every promise of `Bvh`. */
export function faults(bvh: Bvh, bounds: Float32Array, maxLeaf: number): string[] {
  const found: string[] = [];
  const expect = (isRight: boolean, fault: string) => {
    if (!isRight && found.length < 10) found.push(fault);
  };
  const primitiveCount = bounds.length / 6;
  const nodeCount = bvh.axes.length;
  for (const [name, length] of [
    ["bounds", bvh.bounds.length / 6],
    ["links", bvh.links.length],
    ["counts", bvh.counts.length],
  ] as const) {
    expect(length === nodeCount, `${name} is of ${length} nodes, axes of ${nodeCount}`);
  }
  const sorted = bvh.order.slice().sort();
  expect(sorted.length === primitiveCount, `order holds ${sorted.length} primitives`);
  expect(
    sorted.every((primitive, i) => primitive === i),
    "order is no permutation",
  );

  let nextSlot = 0;
  let deepest = 0;
  /** Checks the subtree at `node`. @returns the node after its last and the union of its primitives' boxes. */
  const visit = (node: number, depth: number): { after: number; box: number[] } => {
    if (node >= nodeCount) throw new Error(`node ${node} of ${nodeCount}`);
    let box = [...EMPTY];
    let after = node + 1;
    if (bvh.axes[node] === 3) {
      const count = bvh.counts[node]!;
      expect(count <= maxLeaf, `leaf ${node} has ${count} primitives`);
      expect(count > 0 || primitiveCount === 0, `leaf ${node} is empty`);
      expect(bvh.links[node] === nextSlot, `leaf ${node} starts at slot ${bvh.links[node]}, not ${nextSlot}`);
      for (let i = 0; i < count; i++) {
        const primitive = bvh.order[nextSlot + i]!;
        box = unite(box, bounds.subarray(6 * primitive, 6 * primitive + 6));
      }
      nextSlot += count;
      deepest = Math.max(deepest, depth);
    } else {
      expect(bvh.axes[node]! < 3, `node ${node} has axis ${bvh.axes[node]}`);
      expect(bvh.counts[node] === 0, `inner node ${node} has count ${bvh.counts[node]}`);
      const first = visit(node + 1, depth + 1);
      expect(bvh.links[node] === first.after, `second child of ${node} is ${bvh.links[node]}, not ${first.after}`);
      const second = visit(first.after, depth + 1);
      after = second.after;
      box = unite(first.box, second.box);
    }
    const own = [...bvh.bounds.subarray(6 * node, 6 * node + 6)];
    expect(String(own) === String(box), `bounds of node ${node} are ${own}, not ${box}`);
    return { after, box };
  };
  const { after } = visit(0, 0);
  expect(after === nodeCount, `${nodeCount - after} nodes are in no subtree`);
  expect(nextSlot === primitiveCount, `${primitiveCount - nextSlot} slots are in no leaf`);
  expect(bvh.depth === deepest, `depth is ${bvh.depth}, not ${deepest}`);
  expect(bvh.depth <= MAX_DEPTH, `depth is ${bvh.depth}`);
  return found;
}

const EMPTY = [
  Number.POSITIVE_INFINITY,
  Number.POSITIVE_INFINITY,
  Number.POSITIVE_INFINITY,
  Number.NEGATIVE_INFINITY,
  Number.NEGATIVE_INFINITY,
  Number.NEGATIVE_INFINITY,
] as const;

function unite(a: ArrayLike<number>, b: ArrayLike<number>): number[] {
  return EMPTY.map((_, i) => (i < 3 ? Math.min(a[i]!, b[i]!) : Math.max(a[i]!, b[i]!)) + 0);
}
