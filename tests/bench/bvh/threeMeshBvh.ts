import { BufferAttribute, BufferGeometry } from "three";
import { MeshBVH, type SplitStrategy } from "three-mesh-bvh";
import type { Bvh } from "../../../src/bvh/bvh";

/** What three-mesh-bvh packs a node into: six floats, then two words. */
const NODE_WORDS = 8;
const LEAF_FLAG = 0xffff;

/** A tree of three-mesh-bvh in our form, so that both are measured by the same formulas. */
export type ThreeTree = Pick<Bvh, "bounds" | "counts" | "axes" | "depth"> & {
  /** Of its packed nodes; its triangles are sorted in place. */
  readonly bytes: number;
};

/**
 * Builds it over triangles, which it sorts.
 *
 * @param indices - three per triangle; changed.
 * @param leafSize - its `targetLeafSize`: nodes of as many triangles or fewer are leaves.
 */
export function buildThreeMeshBvh(
  positions: Float32Array,
  indices: Uint32Array,
  strategy: SplitStrategy,
  leafSize: number,
): MeshBVH {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(indices, 1));
  return new MeshBVH(geometry, { strategy, targetLeafSize: leafSize, setBoundingBox: false });
}

/** It stores a node as a second child's distance in nodes, or as a leaf's range. */
export function readThreeMeshBvh(tree: MeshBVH): ThreeTree {
  const root = (tree as unknown as { _roots: ArrayBuffer[] })._roots[0]!;
  const floats = new Float32Array(root);
  const words = new Uint32Array(root);
  const count = words.length / NODE_WORDS;
  const [bounds, counts, axes] = [new Float32Array(6 * count), new Uint8Array(count), new Uint8Array(count)];
  const depths = new Uint32Array(count);
  let depth = 0;
  for (let node = 0; node < count; node++) {
    const at = node * NODE_WORDS;
    bounds.set(floats.subarray(at, at + 6), 6 * node);
    const tag = words[at + 7]!;
    if (tag >>> 16 === LEAF_FLAG) {
      counts[node] = tag & 0xffff;
      axes[node] = 3;
    } else {
      axes[node] = tag & 3;
      depths[node + 1] = depths[node]! + 1;
      depths[node + words[at + 6]!] = depths[node]! + 1;
    }
    depth = Math.max(depth, depths[node]!);
  }
  return { bounds, counts, axes, depth, bytes: root.byteLength };
}
