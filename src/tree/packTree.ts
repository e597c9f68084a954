import type { Bvh } from "../bvh/bvh";

const NODE_WORDS = 8;
const LEAF_AXIS = 3;

// Boxes are told in whole steps of a grid over their parent's box. Of at most this many: what they grow by still fits a byte.
const STEPS = 253;
// A box reaches at least this share of a step further than what it holds: more than the shader's arithmetic can be wrong by.
const MARGIN = 2 ** -6;

// Where a node of nothing is: as far away as rays end.
const NOWHERE = 1e18;

/**
 * A tree as `wgsl/tree.wgsl` reads it: its inner nodes, in the same order, each with the boxes of both its children on a grid
 * over its own (Ylitie, Karras, Laine 2017, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", section 3,
 * with two children), 32 bytes:
 *
 *      0  lower corner of its box, f32 x, y, z
 *     12  of the first child that is a leaf, the slot of its first item; without leaves, the number of the second child
 *     16  along x, a byte each: half size of the first child's box, in half steps; its middle, in steps; half size of the
 *         second's; its middle less 128, signed
 *     20  along y, likewise
 *     24  along z, likewise
 *     28  3 bits: items of the first child, 0 if it is a node; 3 bits: of the second; 1 unused bit; 3 × 8 bits: exponents of the
 *         steps along x, y and z, as an f32 has them; 1 unused bit
 *
 * The items of a second leaf follow those of the first. A child that is a node, but for the second of two, is the next node. A
 * tree of one leaf becomes a node of it and a node that no ray meets.
 */
export function packTree({ bounds, links, axes, counts }: Bvh): ArrayBuffer {
  const isLeaf = (node: number) => axes[node] === LEAF_AXIS;
  // Number among the inner nodes.
  const rank = new Uint32Array(axes.length);
  let innerCount = 0;
  for (let node = 0; node < axes.length; node++) if (!isLeaf(node)) rank[node] = innerCount++;

  const buffer = new ArrayBuffer(4 * NODE_WORDS * Math.max(innerCount, 2));
  const [floats, words] = [new Float32Array(buffer), new Uint32Array(buffer)];
  for (let node = 0; node < axes.length; node++) {
    if (isLeaf(node)) continue;
    const [first, second] = [node + 1, links[node]!];
    const at = NODE_WORDS * rank[node]!;
    putBoxes(at, node, first, second);
    const told = isLeaf(first) ? first : second;
    words[at + 3] = isLeaf(told) ? links[told]! : rank[told]!;
    words[at + 7]! |= counts[first]! | (counts[second]! << 3);
  }
  if (innerCount === 0) {
    const count = counts[0]!;
    if (count > 0) putBoxes(0, 0, 0, 0);
    words[7]! |= count;
    const nothing = count > 0 ? NODE_WORDS : 0;
    floats.fill(NOWHERE, nothing, nothing + 3);
  }
  return buffer;

  function putBoxes(at: number, node: number, first: number, second: number): void {
    for (let axis = 0; axis < 3; axis++) {
      const lower = bounds[6 * node + axis]!;
      const exponent = exponentAbove((bounds[6 * node + 3 + axis]! - lower) / STEPS);
      const perStep = powerOfTwo(127 - exponent);
      floats[at + axis] = lower;
      words[at + 4 + axis] = spanOf(first, axis, lower, perStep, 0) | (spanOf(second, axis, lower, perStep, 128) << 16);
      words[at + 7]! |= exponent << (7 + 8 * axis);
    }
  }

  /** Half size and middle. */
  function spanOf(child: number, axis: number, origin: number, perStep: number, bias: number): number {
    const from = (bounds[6 * child + axis]! - origin) * perStep;
    const to = (bounds[6 * child + 3 + axis]! - origin) * perStep;
    const middle = Math.round((from + to) / 2);
    const half = Math.ceil(2 * Math.max(middle - from, to - middle) + MARGIN);
    return half | (((middle - bias) & 0xff) << 8);
  }
}

const float = new Float32Array(1);
const bits = new Uint32Array(float.buffer);

/** The exponent, as an f32 stores it, of the least power of two that is not below a value. */
function exponentAbove(value: number): number {
  float[0] = value;
  return Math.max((bits[0]! + 0x7fffff) >>> 23, 1);
}

/** Of those that an f32 has; with `2 ** exponent` instead, trees took twice as long to pack. */
function powerOfTwo(exponent: number): number {
  bits[0] = (exponent + 127) << 23;
  return float[0]!;
}
