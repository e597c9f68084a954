import { describe, expect, test } from "vitest";
import { arc, circle, revolve, squircle } from "../../../demo/revolve";

const can = [
  [[0, 0], ...arc([0.8, 0.2], 0.2, -90, 0), [1, 2]] as const,
  [
    [1, 2],
    [0, 2],
  ] as const,
];

describe.each([
  ["a circle", circle],
  ["a squircle", squircle(5)],
])("a profile turned around %s", (_, outline) => {
  const { positions, normals, tangents, indices } = revolve(can, { outline, segments: 32 });
  const at = (values: readonly number[], vertex: number, width = 3) => values.slice(width * vertex, width * vertex + 3);

  test("has its fronts outside, on the side of its normals", () => {
    for (let i = 0; i < indices.length; i += 3) {
      const [a, b, c] = indices.slice(i, i + 3).map((vertex) => at(positions, vertex)) as [
        number[],
        number[],
        number[],
      ];
      const front = cross(subtract(b, a), subtract(c, a));
      expect(dot(front, subtract(a, [0, 1, 0]))).toBeGreaterThan(0);
      for (const vertex of indices.slice(i, i + 3)) expect(dot(front, at(normals, vertex))).toBeGreaterThan(0);
    }
  });

  test("has unit normals and tangents, at right angles", () => {
    for (let vertex = 0; vertex < positions.length / 3; vertex++) {
      const [normal, tangent] = [at(normals, vertex), at(tangents, vertex, 4)];
      expect(Math.hypot(...normal)).toBeCloseTo(1);
      expect(Math.hypot(...tangent)).toBeCloseTo(1);
      expect(dot(normal, tangent)).toBeCloseTo(0);
    }
  });

  test("is closed", () => {
    const edges = new Map<string, number>();
    const name = (vertex: number) => at(positions, vertex).join();
    for (let i = 0; i < indices.length; i++) {
      const [from, to] = [indices[i]!, indices[i % 3 === 2 ? i - 2 : i + 1]!].map(name) as [string, string];
      edges.set(`${from} ${to}`, (edges.get(`${from} ${to}`) ?? 0) + 1);
    }
    for (const [edge, count] of edges) {
      expect(count).toBe(1);
      expect(edges.get(edge.split(" ").reverse().join(" "))).toBe(1);
    }
  });
});

const subtract = (a: readonly number[], b: readonly number[]) => a.map((value, i) => value - b[i]!);
const dot = (a: readonly number[], b: readonly number[]) => a.reduce((sum, value, i) => sum + value * b[i]!, 0);
const cross = ([a = 0, b = 0, c = 0]: readonly number[], [x = 0, y = 0, z = 0]: readonly number[]) => [
  b * z - c * y,
  c * x - a * z,
  a * y - b * x,
];
