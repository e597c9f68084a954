import { afterAll, expect, test } from "vitest";
import { parseScene } from "../../../src/scene/parseScene";
import type { Scene, SceneObject, Vec3 } from "../../../src/scene/schema";
import { sceneOf } from "../../support/compiled";
import { add, type Meeting, meetings, scale, subtract } from "../../support/oracle";
import { createRandom, randomDirection } from "../../support/random";
import { unit } from "../../support/solids";
import { count, LONG, small } from "../../support/stability";
import { recordStability, type StabilityRow } from "../../support/stabilityRows";
import { type Method, NONE, Rays, tally, traceRays } from "../../support/traceRays";

const RAYS = 50_000 * LONG;
const ULP = 2 ** -23;
const material = "lambert";
const rows: StabilityRow[] = [];

test("every axis-aligned ray at a grid of triangles hits it, at its height, seed 7", async () => {
  const cells = 6;
  const vertex = (i: number, j: number): Vec3 => [i, j, 0.25];
  const grid = Array.from({ length: cells * cells }, (_, k): SceneObject[] => {
    const [i, j] = [k % cells, Math.floor(k / cells)];
    const [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
    return [
      { type: "triangle", vertices: [a, b, c], material },
      { type: "triangle", vertices: [a, c, d], material },
    ];
  }).flat();
  const random = createRandom(7);
  const rays = new Rays(RAYS);
  for (let i = 0; i < RAYS; i++) {
    // At vertices, at edges, at diagonals and anywhere; the rim of the grid left out.
    const [x, y] = [1 + Math.floor((cells - 2) * random()), 1 + Math.floor((cells - 2) * random())];
    const part = random();
    const [u, v] = [
      [0, 0],
      [part, 0],
      [0, part],
      [part, part],
      [part, random()],
    ][i % 5]!;
    rays.set(i, [x + u!, y + v!, 8], [0, 0, -1]);
  }
  let worst = 0;
  const wrong = async (method: Method) => {
    const { id, t } = await traceRays(sceneOf(grid), rays, method);
    worst = 0;
    return tally(RAYS, (i) => {
      worst = Math.max(worst, Math.abs(t[i]! - 7.75));
      return id[i] === NONE || Math.abs(t[i]! - 7.75) > 4 * ULP * 7.75;
    });
  };
  const ours = await wrong("ours");
  rows.push({
    case: "Axis-aligned rays at vertices, edges and diagonals of a grid of triangles",
    asserted: "all hit, at the distance to 4 ULP",
    inputs: RAYS,
    worst: `${ours} don't; distance to ${small(worst)}`,
    textbook: `${count(await wrong("textbook"))} don't: Möller–Trumbore`,
  });
  expect(ours).toBe(0);
});

test("boxes meet rays with zero components and origins on their slabs as in doubles, seed 8", async () => {
  const center: Vec3 = [0.25, 0.5, -0.125];
  const half: Vec3 = [0.5, 0.75, 0.25];
  const scene = sceneOf([{ type: "box", center, size: scale(half, 2), material }]);
  const random = createRandom(8);
  const axis = () => Math.floor(3 * random());
  const rays = new Rays(RAYS);
  for (let i = 0; i < RAYS; i++) {
    const o = [0, 1, 2].map((k) => center[k]! + Math.round(256 * (4 * random() - 2)) / 256);
    const d = [...randomDirection(random)];
    d[axis()] = random() < 0.5 ? 0 : -0;
    if (random() < 0.5) d[axis()] = 1e-30 * (random() - 0.5);
    const on = axis();
    if (random() < 0.5) o[on] = center[on]! + (random() < 0.5 ? 1 : -1) * half[on]!;
    if (d.every((component) => Math.abs(component) < 1e-6)) d[on] = 1;
    rays.set(i, o as unknown as Vec3, unit(d as unknown as Vec3));
  }
  await compare(
    "Boxes: rays with zero components, origins on a slab's plane",
    scene,
    rays,
    16 * ULP * 6,
    "slabs by 1/d",
  );
});

test("planes and quads meet grazing rays as in doubles, seed 9", async () => {
  const random = createRandom(9);
  const scene = sceneOf([
    { type: "plane", point: [0, -0.5, 0], normal: [0, 1, 0], material },
    { type: "plane", point: [0, -9, 0], normal: [0.3, 0.8, -0.51], material },
    { type: "quad", corner: [-4, 0.25, -4], edge1: [8, 0, 0], edge2: [0, 0, 8], material },
  ]);
  const rays = new Rays(RAYS);
  for (let i = 0; i < RAYS; i++) {
    const [phi, slope] = [2 * Math.PI * random(), (random() < 0.5 ? 1 : -1) * 10 ** (-1 - 6 * random())];
    rays.set(i, [2 * random() - 1, random() - 0.25, 2 * random() - 1], unit([Math.cos(phi), slope, Math.sin(phi)]));
  }
  await compare(
    "Planes and a quad under rays that graze at up to 10⁻⁷",
    scene,
    rays,
    16 * ULP * 12,
    "the same formula",
  );
});

test("sliver triangles are met by rays at them and by none beside them, seed 10", async () => {
  const bound = 16 * ULP * 6;
  const random = createRandom(10);
  let [missed, met, wrongTextbook] = [0, 0, 0];
  for (const width of [1e-1, 1e-2, 1e-3, 1e-4]) {
    // Along (4, 1, 0), its third vertex off the line by the width.
    const [a, b]: [Vec3, Vec3] = [
      [-2, 0.25, 0],
      [2, 1.25, 0],
    ];
    const across = unit([-1, 4, 0]);
    const c = add(scale(add(a, b), 0.5), scale(across, width));
    const scene = sceneOf([{ type: "triangle", vertices: [a, b, c], material }]);
    const rays = new Rays(RAYS);
    const isAt = (i: number) => i % 2 === 0;
    for (let i = 0; i < RAYS; i++) {
      const o: Vec3 = add([0, 0.75, 0], scale(unit([random() - 0.5, random() - 0.5, 1]), i % 4 < 2 ? 3 : -3));
      // At half the height, or beside the long edge or the vertex by more than f32 can blur.
      const height = isAt(i) ? 0.5 * width : random() < 0.5 ? -2 * bound : width + 2 * bound;
      const along = 0.4 * (random() - 0.5);
      const aim = add(add(scale(add(a, b), 0.5), scale(subtract(b, a), along)), scale(across, height));
      rays.set(i, o, unit(subtract(aim, o)));
    }
    const ours = await traceRays(scene, rays);
    const textbook = await traceRays(scene, rays, "textbook");
    const isMissed = ({ id }: typeof ours) => tally(RAYS, (i) => isAt(i) && id[i] === NONE);
    const isMet = ({ id }: typeof ours) => tally(RAYS, (i) => !isAt(i) && id[i] !== NONE);
    missed += isMissed(ours);
    met += isMet(ours);
    wrongTextbook += isMissed(textbook) + isMet(textbook);
  }
  rows.push({
    case: "Sliver triangles 4 long and 10⁻¹ to 10⁻⁴ high",
    asserted: `rays at half their height hit, rays ${small(2 * bound)} beside them don't`,
    inputs: 4 * RAYS,
    worst: `${missed + met} wrong`,
    textbook: `${count(wrongTextbook)} wrong: Möller–Trumbore`,
  });
  expect({ missed, met }).toEqual({ missed: 0, met: 0 });
});

test("triangles without area are met by no ray, seed 11", async () => {
  const corners: readonly [Vec3, Vec3, Vec3][] = [
    [
      [-1, 2, 0],
      [0, 2, 0],
      [1, 2, 0],
    ],
    [
      [0, 2, 0],
      [0, 2, 0],
      [1, 2, 1],
    ],
    [
      [0, 2, 1],
      [0, 2, 1],
      [0, 2, 1],
    ],
    [
      [0.1, 0.2, 0.3],
      [0.2, 0.4, 0.6],
      [0.4, 0.8, 1.2],
    ],
  ];
  const random = createRandom(11);
  const rays = new Rays(RAYS);
  for (let i = 0; i < RAYS; i++) {
    const o = add([0, 1, 0], scale(randomDirection(random), 3));
    const [a, , c] = corners[i % 4]!;
    rays.set(i, o, unit(subtract(add(a, scale(subtract(c, a), random())), o)));
  }
  const scene = sceneOf(corners.map((vertices): SceneObject => ({ type: "triangle", vertices, material })));
  const { id } = await traceRays(scene, rays);
  const ours = tally(RAYS, (i) => id[i] !== NONE);
  rows.push({
    case: "Rays at triangles without area",
    asserted: "0 hits",
    inputs: RAYS,
    worst: `${ours} hits`,
  });
  expect(ours).toBe(0);
});

afterAll(() => recordStability("planes", rows));

/** Holds every hit to one of those in doubles, unless f32 can't tell: within `bound` of an edge, or of the origin. */
async function compare(name: string, scene: Scene, rays: Rays, bound: number, formula: string): Promise<void> {
  const { objects } = parseScene(scene);
  const measure = async (method: Method) => {
    const { id, t } = await traceRays(scene, rays, method);
    let [worst, wrong] = [0, 0];
    for (let i = 0; i < rays.count; i++) {
      const expected = meetings(objects, rays.origin(i), rays.direction(i));
      const found = expected.find((meeting) => meeting.id === id[i] && isSame(meeting, t[i]!, bound));
      const before = expected.filter((meeting) => !found || meeting.t < found.t);
      const isClear = (meeting: Meeting) =>
        0.25 * meeting.margin * meeting.cosine > bound && meeting.t * meeting.cosine > bound && meeting.t < 1e17;
      if (before.some(isClear) || (id[i] !== NONE && !found && !isNearMiss(objects, id[i]!, rays, i, bound))) wrong++;
      if (found) worst = Math.max(worst, Math.abs(found.t - t[i]!) * found.cosine);
    }
    return { worst, wrong };
  };
  const ours = await measure("ours");
  const textbook = await measure("textbook");
  rows.push({
    case: name,
    asserted: `same primitive as in doubles, met within ${small(bound)} of it and 2 ULP of the way there`,
    inputs: rays.count,
    worst: `${small(ours.worst)}; ${ours.wrong} wrong`,
    textbook: `${small(textbook.worst)}; ${count(textbook.wrong)} wrong: ${formula}`,
  });
  expect(ours.wrong).toBe(0);
}

// A normal is rounded too, and with it the plane turned by an ULP.
function isSame(meeting: Meeting, t: number, bound: number): boolean {
  return Math.abs(meeting.t - t) * meeting.cosine <= bound + 2 * ULP * t;
}

/** Whether a ray from beside or behind passes the object's edge within `bound`: moved by it, it would meet it. */
function isNearMiss(
  objects: ReturnType<typeof parseScene>["objects"],
  id: number,
  rays: Rays,
  i: number,
  bound: number,
) {
  const [o, d] = [rays.origin(i), rays.direction(i)];
  const steps = [-2 * bound, 2 * bound];
  return steps.some((x) =>
    steps.some((y) => steps.some((z) => meetings(objects, add(o, [x, y, z]), d).some((meeting) => meeting.id === id))),
  );
}
