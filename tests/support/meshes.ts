// Meshes made by formula.

import type { SceneObject, Vec3 } from "../../src/scene/schema";

export type MeshData = { readonly positions: number[]; readonly indices: number[]; readonly normals?: number[] };

/**
 * A closed surface r(longitude, latitude) around the origin, of about `triangles` triangles, whose front is outside.
 *
 * @param radius - in units of 1, of longitude and latitude in radians.
 */
export function closedSurface(triangles: number, radius: (longitude: number, latitude: number) => number): MeshData {
  const rows = Math.max(Math.round(Math.sqrt(triangles / 4)), 2);
  const columns = 2 * rows;
  const at = (row: number, column: number): Vec3 => {
    const [b, a] = [Math.PI * (row / rows - 0.5), (2 * Math.PI * column) / columns];
    const r = radius(a, b);
    return [r * Math.cos(b) * Math.cos(a), r * Math.sin(b), r * Math.cos(b) * Math.sin(a)];
  };
  const positions = [...at(0, 0)];
  for (let row = 1; row < rows; row++)
    for (let column = 0; column < columns; column++) positions.push(...at(row, column));
  positions.push(...at(rows, 0));
  const vertex = (row: number, column: number) => {
    if (row === 0) return 0;
    if (row === rows) return 1 + (rows - 1) * columns;
    return 1 + (row - 1) * columns + (column % columns);
  };
  const indices: number[] = [];
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      if (row > 0) indices.push(vertex(row, column), vertex(row + 1, column + 1), vertex(row, column + 1));
      if (row < rows - 1) indices.push(vertex(row, column), vertex(row + 1, column), vertex(row + 1, column + 1));
    }
  }
  return { positions, indices };
}

/** The bumpy sphere of the peers' measurements: radius 0.5·(1 + 0.1·sin 6a·sin 5b) over longitude a and latitude b. */
export function bumpySphere(triangles: number): MeshData {
  return closedSurface(triangles, (a, b) => 0.5 * (1 + 0.1 * Math.sin(6 * a) * Math.sin(5 * b)));
}

/** A unit sphere with the normals of the sphere. */
export function smoothSphere(triangles: number): MeshData {
  const sphere = closedSurface(triangles, () => 1);
  return { ...sphere, normals: sphere.positions };
}

/** A convex solid of 20·4^splits triangles, no two of them in a plane, with its vertices on the unit sphere. */
export function icosphere(splits: number): MeshData {
  const g = (1 + Math.sqrt(5)) / 2;
  const onSphere = (v: readonly number[]) => v.map((x) => x / Math.hypot(...v));
  const rectangle = [-1, 1].flatMap((a) => [-g, g].map((b): [number, number] => [a, b]));
  const vertices = [0, 1, 2].flatMap((axis) =>
    rectangle.map(([a, b]) => onSphere([0, 1, 2].map((i) => [0, a, b][(i + axis) % 3]!))),
  );
  const distance = (i: number, j: number) => Math.hypot(...vertices[i]!.map((x, axis) => x - vertices[j]![axis]!));
  const edge = 2 / Math.hypot(1, g);
  const areNear = (i: number, j: number) => Math.abs(distance(i, j) - edge) < 1e-9;
  let faces: [number, number, number][] = [];
  for (let a = 0; a < 12; a++)
    for (let b = a + 1; b < 12; b++)
      for (let c = b + 1; c < 12; c++)
        if (areNear(a, b) && areNear(b, c) && areNear(c, a)) faces.push(isOutward(a, b, c) ? [a, b, c] : [a, c, b]);

  function isOutward(a: number, b: number, c: number): boolean {
    const [p, q, r] = [vertices[a]!, vertices[b]!, vertices[c]!] as [number[], number[], number[]];
    const at = (v: number[], i: number) => v[i % 3]!;
    return p.reduce((sum, x, i) => sum + x * (at(q, i + 1) * at(r, i + 2) - at(q, i + 2) * at(r, i + 1)), 0) > 0;
  }

  for (let split = 0; split < splits; split++) {
    const middles = new Map<string, number>();
    const middle = (a: number, b: number) => {
      const key = `${Math.min(a, b)} ${Math.max(a, b)}`;
      const known = middles.get(key);
      if (known !== undefined) return known;
      middles.set(key, vertices.push(onSphere(vertices[a]!.map((x, axis) => x + vertices[b]![axis]!))) - 1);
      return vertices.length - 1;
    };
    faces = faces.flatMap(([a, b, c]) => {
      const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
      return [
        [a, ab, ca],
        [ab, b, bc],
        [ca, bc, c],
        [ab, bc, ca],
      ];
    });
  }
  return { positions: vertices.flat(), indices: faces.flat() };
}

/** The same mesh with its front inside. */
export function insideOut({ indices, ...rest }: MeshData): MeshData {
  return { ...rest, indices: indices.toReversed() };
}

/** The twelve triangles of a cube of half size 1; its front is outside, or inside. */
export function cube(front: "outside" | "inside" = "outside"): MeshData {
  const positions = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [i & 1, (i >> 1) & 1, i >> 2].map((bit) => 2 * bit - 1));
  const faces = [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ] as const;
  const outside = { positions, indices: faces.flatMap(([a, b, c, d]) => [a, b, c, a, c, d]) };
  return front === "outside" ? outside : insideOut(outside);
}

/** The same mesh elsewhere and of another size. */
export function placed({ positions, ...rest }: MeshData, size: number, [x, y, z]: Vec3): MeshData {
  const offset = [x, y, z];
  return { ...rest, positions: positions.map((value, i) => size * value + offset[i % 3]!) };
}

/** As an object of a scene. */
export function meshObject(data: MeshData, material: string): SceneObject {
  return { type: "mesh", ...data, material };
}

/** Vertices of triangle `i`. */
export function triangleAt({ positions, indices }: MeshData, i: number): [Vec3, Vec3, Vec3] {
  const vertex = (corner: number): Vec3 => {
    const at = 3 * indices[3 * i + corner]!;
    return [positions[at]!, positions[at + 1]!, positions[at + 2]!];
  };
  return [vertex(0), vertex(1), vertex(2)];
}
