import { beforeAll, describe, expect, test } from "vitest";
import { parseScene } from "../../../src/scene/parseScene";
import type { Scene, Vec3 } from "../../../src/scene/schema";
import { prepareGeometry } from "../../../src/tree/geometry";
import { bumpySphere, type MeshData, meshObject, placed, triangleAt } from "../../support/meshes";
import { createRandom, randomDirection } from "../../support/random";
import { NONE, Rays, type Traced, traceRays } from "../../support/traceRays";

const RAYS = 4000;

/** Triangles anywhere, of any size. */
function soup(count: number, seed: number, size: (i: number) => number): MeshData {
  const random = createRandom(seed);
  const positions: number[] = [];
  for (let i = 0; i < count; i++) {
    const middle = [random(), random(), random()].map((x) => 4 * x - 2);
    for (let corner = 0; corner < 3; corner++) {
      const direction = randomDirection(random);
      positions.push(...middle.map((x, axis) => Math.fround(x + size(i) * direction[axis]!)));
    }
  }
  return { positions, indices: Array.from({ length: 3 * count }, (_, i) => i) };
}

/** A level grid: every ray along an axis runs in the planes of boxes and along edges. */
function grid(cells: number): MeshData {
  const positions: number[] = [];
  for (let z = 0; z <= cells; z++) for (let x = 0; x <= cells; x++) positions.push(x / 4 - 2, 0, z / 4 - 2);
  const indices: number[] = [];
  for (let z = 0; z < cells; z++) {
    for (let x = 0; x < cells; x++) {
      const a = z * (cells + 1) + x;
      indices.push(a, a + cells + 1, a + 1, a + 1, a + cells + 1, a + cells + 2);
    }
  }
  return { positions, indices };
}

const SOUPS: Readonly<Record<string, MeshData>> = {
  "one triangle": soup(1, 1, () => 2),
  "two triangles": soup(2, 2, () => 2),
  "300 triangles of one size": soup(300, 3, () => 0.3),
  "1000 triangles from 10⁻⁴ to 4": soup(1000, 4, (i) => 4 * 10 ** (-4 * ((i * 0.618) % 1))),
  "300 slivers": (() => {
    const { positions, indices } = soup(300, 5, () => 1);
    const random = createRandom(6);
    for (let i = 0; i < positions.length; i += 9) {
      for (let axis = 0; axis < 3; axis++) {
        positions[i + 6 + axis] = Math.fround(positions[i + 3 + axis]! + 1e-3 * (random() - 0.5));
      }
    }
    return { positions, indices };
  })(),
  "a level grid": grid(16),
  "a closed surface of 1000 triangles": bumpySphere(1000),
};

describe.each(Object.entries(SOUPS))("%s, seed 1", (_, data) => {
  const rays = raysAt(data, 1);
  let traced: Traced;
  let triangleOf: (id: number) => number;

  beforeAll(async () => {
    const scene = sceneOf(data);
    const geometry = (await prepareGeometry(parseScene(scene)))!;
    const triangles = new Map(Array.from(geometry.slotOf, (slot, triangle) => [slot, triangle]));
    triangleOf = (id) => (id === NONE ? -1 : triangles.get(id - 1)!); // the mesh itself is primitive 0
    traced = await traceRays(scene, rays);
  });

  test("the closest hit equals that of a brute-force search in doubles", () => {
    let hits = 0;
    for (let i = 0; i < RAYS; i++) {
      const found = triangleOf(traced.id[i]!);
      const met = meetings(data, rays.origin(i), rays.direction(i));
      const best = met.sure[0];
      if (found < 0) {
        // What is surely met must be found.
        expect(best, `ray ${i} misses`).toBeUndefined();
        continue;
      }
      hits++;
      const own = met.possible.find(({ triangle }) => triangle === found);
      expect(own, `ray ${i} cannot meet triangle ${found}`).toBeDefined();
      expect(Math.abs(traced.t[i]! - own!.t), `distance of ray ${i}`).toBeLessThanOrEqual(own!.error);
      if (best)
        expect(own!.t - own!.error, `ray ${i} passes triangle ${best.triangle}`).toBeLessThanOrEqual(
          best.t + best.error,
        );
    }
    expect(hits).toBeGreaterThan(RAYS / 20);
  });
});

type Meeting = { readonly triangle: number; readonly t: number; readonly error: number };

/** Triangles met by a ray, nearest first: those that it surely meets, and those that rounding to f32 may make it meet. */
function meetings(data: MeshData, o: Vec3, d: Vec3): { sure: Meeting[]; possible: Meeting[] } {
  const sure: Meeting[] = [];
  const possible: Meeting[] = [];
  for (let triangle = 0; triangle < data.indices.length / 3; triangle++) {
    const [a, b, c] = triangleAt(data, triangle);
    const [e1, e2, s] = [subtract(b, a), subtract(c, a), subtract(o, a)];
    const n = cross(e1, e2);
    const det = -dot(d, n);
    if (det === 0) continue;
    const t = dot(s, n) / det;
    const q = cross(s, d);
    const [u, v] = [dot(e2, q) / det, -dot(e1, q) / det];
    // A dozen operations of 2⁻²³ on coordinates as large as the way; grazing, and slim triangles, blow that up.
    const size = Math.max(...[a, b, c].map((vertex) => Math.hypot(...subtract(vertex, o))));
    const area = Math.hypot(...n);
    const cosine = Math.abs(det) / (area * Math.hypot(...d));
    const error = (16 * 2 ** -23 * size) / Math.max(cosine, 1e-9);
    const edge = Math.max(Math.hypot(...e1), Math.hypot(...e2));
    const slack = (error * edge) / area;
    const inside = Math.min(u, v, 1 - u - v);
    if (t > error && inside > slack) sure.push({ triangle, t, error });
    if (t > -error && inside > -slack) possible.push({ triangle, t, error: error * (1 + edge ** 2 / area) });
  }
  sure.sort((x, y) => x.t - y.t);
  return { sure, possible };
}

/** From around and inside of the mesh, at points of it and anywhere; a quarter along the axes, a quarter in a plane of two. */
function raysAt(data: MeshData, seed: number): Rays {
  const random = createRandom(seed);
  const rays = new Rays(RAYS);
  for (let i = 0; i < RAYS; i++) {
    const [a, b, c] = triangleAt(data, Math.floor(random() * (data.indices.length / 3)));
    const [u, v] = [random(), random()].sort((x, y) => x - y) as [number, number];
    const aim = [0, 1, 2].map((axis) => u * a[axis]! + (v - u) * b[axis]! + (1 - v) * c[axis]!) as unknown as Vec3;
    const direction = [...randomDirection(random)] as [number, number, number];
    if (i % 4 === 0) for (const axis of [0, 1, 2].filter((axis) => axis !== i % 3)) direction[axis] = 0;
    if (i % 4 === 1) direction[i % 3] = 0;
    const d = unit(direction);
    const reach = 6 * random();
    rays.set(
      i,
      [aim[0] - reach * d[0], aim[1] - reach * d[1], aim[2] - reach * d[2]].map(Math.fround) as unknown as Vec3,
      d,
    );
  }
  return rays;
}

function sceneOf(data: MeshData): Scene {
  return {
    camera: { position: [0, 0, 5], target: [0, 0, 0] },
    materials: { m: { ior: 1 } },
    objects: [meshObject(placed(data, 1, [0, 0, 0]), "m")],
  };
}

function unit(v: readonly number[]): Vec3 {
  const length = Math.hypot(...v);
  return v.map((x) => Math.fround(x / length)) as unknown as Vec3;
}

function subtract(a: Vec3, b: Vec3): Vec3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a: Vec3, b: Vec3): Vec3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
