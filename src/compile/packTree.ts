import type { Bvh } from "../bvh/buildBvh";

const NODE_WORDS = 16;
const LEAF = 2 ** 31;
const COUNT_SHIFT = 27;

// Coordinates of a child that is not there: as far away as rays end.
const NOWHERE = 1e18;

/**
 * A tree as `wgsl/tree.wgsl` reads it: its inner nodes, in the same order, each with the boxes of both its children (Aila,
 * Laine 2009, "Understanding the Efficiency of Ray Traversal on GPUs"), 64 bytes:
 *
 *      0  lower corner of the first child, f32 x, y, z
 *     12  link to the first child
 *     16  its upper corner
 *     28  link to the second child
 *     32  lower corner of the second child; 4 unused bytes
 *     48  its upper corner; 4 unused bytes
 *
 * A link is the number of an inner node or, with the highest bit set, a leaf: in the next four bits how many items it has,
 * in the others the slot of the first. A tree of one leaf becomes a node whose first child it is.
 */
export function packTree({ bounds, links, axes, counts }: Bvh): ArrayBuffer {
  const isLeaf = (node: number) => axes[node] === 3;
  // Number among the inner nodes.
  const rank = new Uint32Array(axes.length);
  let innerCount = 0;
  for (let node = 0; node < axes.length; node++) if (!isLeaf(node)) rank[node] = innerCount++;

  const buffer = new ArrayBuffer(4 * NODE_WORDS * Math.max(innerCount, 1));
  const [floats, words] = [new Float32Array(buffer), new Uint32Array(buffer)];
  const linkTo = (node: number) =>
    isLeaf(node) ? LEAF + counts[node]! * 2 ** COUNT_SHIFT + links[node]! : rank[node]!;
  const putBox = (at: number, node: number) => {
    for (let axis = 0; axis < 3; axis++) {
      floats[at + axis] = bounds[6 * node + axis]!;
      floats[at + 4 + axis] = bounds[6 * node + 3 + axis]!;
    }
  };

  for (let node = 0; node < axes.length; node++) {
    if (isLeaf(node)) continue;
    const at = NODE_WORDS * rank[node]!;
    putBox(at, node + 1);
    putBox(at + 8, links[node]!);
    words[at + 3] = linkTo(node + 1);
    words[at + 7] = linkTo(links[node]!);
  }
  if (innerCount === 0) {
    floats.fill(NOWHERE);
    if (counts[0]! > 0) putBox(0, 0);
    words[3] = linkTo(0);
    words[7] = LEAF;
  }
  return buffer;
}
