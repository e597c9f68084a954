import { TorusKnotGeometry } from "three";
import { SAH } from "three-mesh-bvh";
import { describe, expect, test } from "vitest";
import { buildBvh } from "../../../src/bvh/buildBvh";
import { INTERSECTION_COST, sahCost, TRAVERSAL_COST } from "../../../src/bvh/sahCost";
import { triangleBounds } from "../../../src/bvh/triangleBounds";
import { buildThreeMeshBvh, readThreeMeshBvh } from "../../bench/bvh/threeMeshBvh";

describe("the cost of a tree", () => {
  test("of one leaf is that of its primitives, and of none 0", () => {
    expect(sahCost(buildBvh(Float32Array.of(0, 0, 0, 1, 2, 3)))).toBe(INTERSECTION_COST);
    expect(sahCost(buildBvh(new Float32Array(0)))).toBe(0);
  });

  test("of two unit cubes two apart is one step, and each by its share of the surface", () => {
    const bvh = buildBvh(Float32Array.of(0, 0, 0, 1, 1, 1, 3, 0, 0, 4, 1, 1), { maxLeaf: 1 });
    expect(sahCost(bvh)).toBeCloseTo(TRAVERSAL_COST + 2 * INTERSECTION_COST * (6 / 18), 12);
  });

  test("is finite where the root has no area", () => {
    expect(sahCost(buildBvh(new Float32Array(600), { maxLeaf: 4 }))).toBeGreaterThan(0);
    expect(sahCost(buildBvh(new Float32Array(600), { maxLeaf: 4 }))).toBeLessThan(1000);
  });
});

describe("a tree costs no more than three-mesh-bvh's best", () => {
  test("on a torus knot of 20,000 triangles, and with leaves as small", () => {
    const geometry = new TorusKnotGeometry(1, 0.4, 200, 50);
    const positions = geometry.attributes.position!.array as Float32Array;
    const indices = Uint32Array.from(geometry.index!.array);
    const bounds = triangleBounds(positions, indices);
    for (const leaf of [1, 4, 10]) {
      const theirs = sahCost(readThreeMeshBvh(buildThreeMeshBvh(positions, indices, SAH, leaf)));
      expect(sahCost(buildBvh(bounds)), `leaves of ${leaf}`).toBeLessThanOrEqual(theirs);
    }
  });
});
