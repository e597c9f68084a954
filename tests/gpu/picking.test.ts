import { describe, expect, test } from "vitest";
import { PathTracer } from "../../src/renderer/pathTracer";
import type { Picked } from "../../src/renderer/picker";
import { parseScene } from "../../src/scene/parseScene";
import type { ResolvedObject, Scene, Vec3 } from "../../src/scene/schema";
import { testDevice } from "../support/device";
import { add, cross, meetings, scale, subtract } from "../support/oracle";

const [WIDTH, HEIGHT] = [24, 16];
// Of the position, in units of the scene's size: f32 rounds the distance and what it is computed from, a dozen times.
const PLACE_ERROR = 24 * 2 ** -23;

const material = "m";
const ALL_KINDS: Scene = {
  camera: { position: [0.3, 1.6, 6], target: [0, 0.8, 0], up: [0.1, 1, 0], verticalFov: 50 },
  materials: { m: { ior: 1 } },
  objects: [
    { type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material },
    { type: "sphere", center: [-1.6, 0.7, 0], radius: 0.7, material },
    { type: "box", center: [0, 0.6, 0.2], size: [0.9, 1.2, 0.7], rotationY: 30, material },
    { type: "box", center: [1.5, 0.4, 0.8], size: [0.8, 0.8, 0.8], material },
    { type: "quad", corner: [-2.5, 0, -2], edge1: [5, 0, 0], edge2: [0, 2, 0], material },
    {
      type: "triangle",
      vertices: [
        [1, 1.2, -1],
        [2.4, 1, -1],
        [1.6, 2.6, -0.5],
      ],
      material,
    },
  ],
  lights: [
    { type: "point", position: [0, 4, 0], power: [100, 100, 100] },
    { type: "sphere", position: [-0.4, 2.3, 0], radius: 0.35, power: [100, 100, 100] },
  ],
};

async function createTracer(scene: Scene): Promise<PathTracer> {
  return PathTracer.create({ scene, width: WIDTH, height: HEIGHT, device: await testDevice() });
}

/** Where a ray of length 1 along the view through (x, y) of the picture goes. */
function directionThrough({ camera }: Scene, x: number, y: number): Vec3 {
  const { position, target, up, verticalFov } = parseScene({ camera, objects: [] }).camera;
  const unit = (v: Vec3) => scale(v, 1 / Math.hypot(...v));
  const forward = unit(subtract(target, position));
  const right = unit(cross(forward, up));
  const tangent = Math.tan((verticalFov * Math.PI) / 360);
  const across = ((2 * x) / WIDTH - 1) * tangent * (WIDTH / HEIGHT);
  const above = (1 - (2 * y) / HEIGHT) * tangent;
  return unit(add(forward, add(scale(right, across), scale(cross(right, forward), above))));
}

test("what is picked at each pixel is what a search in doubles finds first, whatever its kind", async () => {
  const tracer = await createTracer(ALL_KINDS);
  const { objects, lights, camera } = tracer.scene;
  const lamp = lights[1]!;
  if (lamp.type !== "sphere") throw new TypeError("the second light is a sphere");
  // Ids after the objects': the one sphere light.
  const all: ResolvedObject[] = [...objects, { type: "sphere", center: lamp.position, radius: lamp.radius, material }];
  const seen = new Set<string>();
  for (let y = 0.5; y < HEIGHT; y++) {
    for (let x = 0.5; x < WIDTH; x++) {
      const direction = directionThrough(ALL_KINDS, x, y);
      const [first] = meetings(all, camera.position, direction);
      const picked = await tracer.pick(x, y);
      if (first === undefined) {
        expect(picked).toBeUndefined();
        continue;
      }
      const part = first.id < objects.length ? ["object", first.id] : ["light", 1];
      expect([picked?.kind, picked?.index], `at ${x}, ${y}`).toEqual(part);
      seen.add(part.join(" "));
      const tolerance = (PLACE_ERROR * (8 + first.t)) / first.cosine;
      expect(Math.abs(picked!.distance - first.t)).toBeLessThan(tolerance);
      const off = subtract(picked!.position, add(camera.position, scale(direction, first.t)));
      expect(Math.hypot(...off)).toBeLessThan(tolerance);
    }
  }
  expect(seen.size).toBe(ALL_KINDS.objects.length + 1);
  tracer.dispose();
});

describe("picking", () => {
  const middle = (tracer: PathTracer): Promise<Picked | undefined> => tracer.pick(WIDTH / 2, HEIGHT / 2);
  const ball = (z: number): Scene => ({
    camera: { position: [0, 0, 5] },
    materials: { m: {} },
    objects: [{ type: "sphere", center: [0, 0, z], radius: 1, material }],
  });

  test("follows the camera and the scene's values, and other code once the scene needs it", async () => {
    const tracer = await createTracer(ball(0));
    expect(await middle(tracer)).toMatchObject({ kind: "object", index: 0, distance: 4 });
    tracer.setCamera({ position: [0, 0, 8] });
    expect(await middle(tracer)).toMatchObject({ distance: 7, position: [0, 0, 1] });
    await tracer.setScene(ball(-1));
    expect(await middle(tracer)).toMatchObject({ distance: 5 });
    await tracer.setScene({
      ...ball(0),
      objects: [{ type: "box", center: [0, 0, 0], size: [2, 2, 2], material }, ...ball(0).objects],
      camera: { position: [0, 0, 5], target: [0.3, 0.2, 0] },
    });
    expect(await middle(tracer)).toMatchObject({ kind: "object", index: 0 });
    tracer.dispose();
  });

  test("tells a mesh by its object, whichever of its triangles is hit", async () => {
    const tracer = await createTracer({
      ...ball(-3),
      objects: [
        ...ball(-3).objects,
        { type: "mesh", positions: [-2, -2, 0, 2, -2, 0, 2, 2, 0, -2, 2, 0], indices: [0, 1, 2, 0, 2, 3], material },
      ],
      lights: [{ type: "sphere", position: [0, 0, 2], radius: 0.05, power: [1, 1, 1] }],
    });
    for (const [x, y] of [
      [9, 5],
      [15, 11],
    ] as const) {
      expect(await tracer.pick(x, y)).toMatchObject({ kind: "object", index: 1 });
    }
    expect(await middle(tracer)).toMatchObject({ kind: "light", index: 0 });
    expect((await tracer.pick(9, 5))!.position[2]).toBeCloseTo(0, 5);
    // While the code is compiled, the mesh goes.
    const late = tracer.pick(9, 5);
    await tracer.setScene(ball(0));
    await late;
    expect(await middle(tracer)).toMatchObject({ kind: "object", index: 0 });
    tracer.dispose();
  });

  test("is as exact far from the world's origin", async () => {
    const [far, camera] = [1e7, { position: [1e7, 0, 5], target: [1e7, 0, 0] } as const];
    const tracer = await createTracer({
      camera,
      materials: { m: {} },
      objects: [{ type: "sphere", center: [far, 0, 0], radius: 1, material }],
    });
    const picked = await middle(tracer);
    expect(picked?.position[0]).toBe(far);
    expect(picked?.distance).toBeCloseTo(4, 5);
    tracer.dispose();
  });

  test("finds nothing in an empty scene, outside of the picture, and after dispose()", async () => {
    const tracer = await createTracer({ camera: { position: [0, 0, 5] }, objects: [] });
    expect(await middle(tracer)).toBeUndefined();
    await tracer.setScene(ball(0));
    expect(await middle(tracer)).toBeDefined();
    for (const [x, y] of [
      [-1, 8],
      [WIDTH + 1, 8],
      [12, -1],
      [12, HEIGHT + 1],
      [Number.NaN, 8],
    ] as const) {
      expect(await tracer.pick(x, y)).toBeUndefined();
    }
    const late = middle(tracer);
    tracer.dispose();
    await late; // which does not reject
    expect(await middle(tracer)).toBeUndefined();
  });

  test("leaves the picture as it is", async () => {
    const pictures = [];
    for (const picks of [0, 3]) {
      const tracer = await createTracer(ALL_KINDS);
      await tracer.sample(2);
      for (let i = 0; i < picks; i++) await middle(tracer);
      expect(tracer.stats.samples).toBe(2);
      await tracer.sample(2);
      pictures.push(await tracer.readRadiance());
      tracer.dispose();
    }
    expect(pictures[1]).toEqual(pictures[0]);
  });
});
