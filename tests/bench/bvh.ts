import { writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { TorusKnotGeometry } from "three";
import { CENTER, SAH } from "three-mesh-bvh";
import { buildBvh } from "../../src/bvh/buildBvh";
import { INTERSECTION_COST, sahCost, TRAVERSAL_COST } from "../../src/bvh/sahCost";
import { triangleBounds } from "../../src/bvh/triangleBounds";
import { buildThreeMeshBvh, readThreeMeshBvh, type ThreeTree } from "./bvh/threeMeshBvh";
import { describeMachine } from "./machine";
import { median } from "./statistics";

// Builds trees over torus knots, ours and three-mesh-bvh's in one run: node src/cli/run.mjs tests/bench/bvh.ts

const RUNS = 5;
const RESULTS = fileURLToPath(new URL("results/bvh.json", import.meta.url));

/** Segments along the tube and around it; two triangles each. */
const KNOTS = [
  [1000, 50],
  [5000, 100],
] as const;

type Tree = Pick<ThreeTree, "bounds" | "counts" | "axes" | "depth" | "bytes">;

type Row = {
  readonly triangles: number;
  readonly builder: string;
  /** Median of the runs, boxes of triangles included; the first run is not among them. */
  readonly milliseconds: number;
  readonly sahCost: number;
  readonly nodes: number;
  readonly depth: number;
  /** Of the finished tree, the order of its primitives included. */
  readonly bytesPerTriangle: number;
};

export function main(): void {
  const rows = KNOTS.flatMap(([along, around]) => {
    const geometry = new TorusKnotGeometry(1, 0.4, along, around);
    const positions = geometry.attributes.position!.array as Float32Array;
    const indices = Uint32Array.from(geometry.index!.array);
    const theirs = (strategy: typeof SAH | typeof CENTER, leafSize: number) => () => {
      const tree = buildThreeMeshBvh(positions, indices.slice(), strategy, leafSize);
      return () => readThreeMeshBvh(tree);
    };
    const ours = (maxLeaf: number) => () => {
      const bvh = buildBvh(triangleBounds(positions, indices), { maxLeaf });
      const arrays = [bvh.bounds, bvh.links, bvh.axes, bvh.counts, bvh.order];
      return () => ({ ...bvh, bytes: arrays.reduce((sum, array) => sum + array.byteLength, 0) });
    };
    const triangles = indices.length / 3;
    return [
      measure(triangles, "rt-viewer, leaves ≤ 4", ours(4)),
      measure(triangles, "rt-viewer, leaves ≤ 8", ours(8)),
      measure(triangles, "three-mesh-bvh SAH", theirs(SAH, 10)),
      measure(triangles, "three-mesh-bvh SAH, leaves 4", theirs(SAH, 4)),
      measure(triangles, "three-mesh-bvh SAH, leaves 1", theirs(SAH, 1)),
      measure(triangles, "three-mesh-bvh CENTER", theirs(CENTER, 10)),
    ];
  });
  console.table(rows);
  const costs = { traversal: TRAVERSAL_COST, intersection: INTERSECTION_COST };
  writeFileSync(
    RESULTS,
    `${JSON.stringify({ machine: describeMachine(undefined), runs: RUNS, costs, rows }, undefined, 2)}\n`,
  );
}

/** @param build - what is timed; what it returns reads the tree. */
function measure(triangles: number, builder: string, build: () => () => Tree): Row {
  let read = build();
  const times = Array.from({ length: RUNS }, () => {
    const start = performance.now();
    read = build();
    return performance.now() - start;
  });
  const tree = read();
  return {
    triangles,
    builder,
    milliseconds: Math.round(median(times)),
    sahCost: Number(sahCost(tree).toFixed(2)),
    nodes: tree.axes.length,
    depth: tree.depth,
    bytesPerTriangle: Number((tree.bytes / triangles).toFixed(1)),
  };
}
