import { describe, expect, test } from "vitest";
import { type CompiledScene, compileScene } from "../../../src/compile/compileScene";
import { box, plane, pointLight, quad, sphere, sphereLight, triangle } from "../../../src/scene/builders";
import { parseScene } from "../../../src/scene/parseScene";
import type { Scene, Vec3 } from "../../../src/scene/schema";
import { prepareGeometry } from "../../../src/tree/geometry";
import { compile, unpack } from "../../support/compiled";
import { loadReference, REFERENCE_NAMES } from "../../support/reference";

// biome-ignore lint/suspicious/noExplicitAny: edits reach deep into a scene, past unions and readonly
type Draft = any;

// Coordinates are sums of few powers of two, so that moving the scene rounds nothing.
const SCENE = {
  camera: { position: [0, 1, 5], target: [0, 0.5, 0] },
  materials: {
    floor: { baseColor: [0.5, 0.5, 0.5], ior: 1 },
    gloss: { baseColor: [0.25, 0.5, 0.75], roughness: 0.5, metallic: 0.25, ior: 1.5 },
    glow: { ior: 1, emission: [2, 3, 4] },
  },
  objects: [
    plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "floor" }),
    plane({ point: [0, -1, 0], normal: [1, 4, 1], material: "floor" }),
    sphere({ center: [0, 0.5, 0], radius: 0.5, material: "gloss" }),
    box({ center: [2, 0.5, 0], size: [1, 1, 1], rotationY: 30, material: "gloss" }),
    box({ center: [-2, 0.5, 0], size: [1, 2, 1], material: "glow" }),
    quad({ corner: [-1, 2, -1], edge1: [2, 0, 0], edge2: [0, 0, 2], material: "glow" }),
    quad({ corner: [-1, 3, -1], edge1: [2, 1, 0], edge2: [0, 0, 2], material: "floor" }),
    triangle({ vertices: [[0, 0, -2], [1, 0, -2], [0, 1, -2]], material: "floor" }), // biome-ignore format: one line
  ],
  lights: [
    sphereLight({ position: [3, 4, 3], radius: 0.25, power: [10, 20, 30] }),
    pointLight({ position: [-3, 4, 3], power: [30, 20, 10] }),
  ],
  environment: { radiance: [0.5, 0.5, 1] },
} as const satisfies Scene;

/** A copy of the scene with something changed. */
function edited(edit: (scene: Draft) => void): Scene {
  const draft: Draft = structuredClone(SCENE);
  edit(draft);
  return draft;
}

/** What decides whether a scene needs another program. */
function programOf({ sceneModule, features }: CompiledScene) {
  return { sceneModule, features };
}

describe("a change of a value needs no new program", () => {
  test.each<[string, (scene: Draft) => void]>([
    ["the base colour", ({ materials }) => (materials.floor.baseColor = [0.1, 0.2, 0.3])],
    ["the roughness", ({ materials }) => (materials.gloss.roughness = 0.25)],
    ["how metallic a surface is", ({ materials }) => (materials.gloss.metallic = 0.75)],
    ["the index of refraction", ({ materials }) => (materials.gloss.ior = 1.25)],
    ["the emission", ({ materials }) => (materials.glow.emission = [1, 0, 0])],
    ["the position of a sphere", ({ objects }) => (objects[2].center = [0.5, 0.75, 1])],
    ["the radius of a sphere", ({ objects }) => (objects[2].radius = 0.125)],
    ["the height of a plane", ({ objects }) => (objects[0].point = [0, -0.25, 0])],
    ["a slanted normal", ({ objects }) => (objects[1].normal = [1, 5, 2])],
    ["the size of a box", ({ objects }) => (objects[3].size = [1, 2, 0.5])],
    ["the turn of a box", ({ objects }) => (objects[3].rotationY = 31)],
    ["the corner of a quad", ({ objects }) => (objects[5].corner = [-1, 2.5, -1])],
    ["the edge of a quad", ({ objects }) => (objects[6].edge1 = [2, 0.5, 0])],
    ["a vertex", ({ objects }) => (objects[7].vertices[1] = [1.5, 0, -2])],
    ["the position of a sphere light", ({ lights }) => (lights[0].position = [3, 3, 3])],
    ["the radius of a sphere light", ({ lights }) => (lights[0].radius = 1)],
    ["the power of a sphere light", ({ lights }) => (lights[0].power = [1, 2, 3])],
    ["a sphere light turned down", ({ lights }) => (lights[0].power = [0, 0, 0])],
    ["the position of a point light", ({ lights }) => (lights[1].position = [1, 4, 1])],
    ["the power of a point light", ({ lights }) => (lights[1].power = [1, 2, 3])],
    ["the environment", ({ environment }) => (environment.radiance = [1, 0, 0])],
    ["the target of the camera", ({ camera }) => (camera.target = [0, 1, 0.5])],
  ])("%s", (_, edit) => {
    const before = compile(SCENE);
    const after = compile(edited(edit));
    expect(programOf(after)).toEqual(programOf(before));
    expect(after.description).toEqual(before.description);
    expect(after.uniform.byteLength).toBe(before.uniform.byteLength);
    expect(new Uint8Array(after.uniform)).not.toEqual(new Uint8Array(before.uniform));
  });

  test.each<[string, (scene: Draft) => void]>([
    ["where the camera stands", ({ camera }) => (camera.position = [1, 2, 3])],
    ["the field of view", ({ camera }) => (camera.verticalFov = 20)],
    ["the number of bounces", (scene) => (scene.maxBounces = 3)],
    ["a material that no object uses", ({ materials }) => (materials.unused = { roughness: 0, emission: [1, 1, 1] })],
  ])("and %s is not even in the scene's data", (_, edit) => {
    expect(compile(edited(edit))).toEqual(compile(SCENE));
  });
});

describe("a change of what there is needs a new program", () => {
  test.each<[string, (scene: Draft) => void]>([
    ["another sphere", ({ objects }) => objects.push(sphere({ center: [0, 5, 0], radius: 1, material: "floor" }))],
    ["an object less", ({ objects }) => objects.pop()],
    ["another order", ({ objects }) => objects.reverse()],
    ["a light less", ({ lights }) => lights.pop()],
    ["a perfect mirror", ({ materials }) => (materials.gloss.roughness = 0)],
    ["another masking", ({ materials }) => (materials.gloss.masking = "schlick-beckmann")],
    ["multiple scattering", ({ materials }) => Object.assign(materials.gloss, { metallic: 1, multiscatter: true })],
    ["a plane that tilts", ({ objects }) => (objects[0].normal = [0.1, 1, 0])],
    ["a box that starts to turn", ({ objects }) => (objects[4].rotationY = 10)],
    ["an emitter that goes dark", ({ materials }) => (materials.glow.emission = [0, 0, 0])],
    ["the environment switched off", ({ environment }) => (environment.radiance = [0, 0, 0])],
  ])("%s", (_, edit) => {
    expect(programOf(compile(edited(edit)))).not.toEqual(programOf(compile(SCENE)));
  });
});

test("no text of the user's reaches the shader", () => {
  const evil = "}; fn evil() {} /*";
  const scene = edited((draft: Draft) => {
    draft.$schema = evil;
    draft.materials[evil] = draft.materials.floor;
    delete draft.materials.floor;
    for (const object of draft.objects) if (object.material === "floor") object.material = evil;
  });
  expect(compile(scene)).toEqual(compile(SCENE));
  expect(compile(scene).sceneModule).not.toContain("evil");
});

test.each([1, -1])("a scene far from the world's origin compiles to the same bytes, side %i", (side) => {
  const far: Vec3 = [side * 2 ** 20, side * 2 ** 19, side * 2 ** 18];
  const move = (p: Vec3): Vec3 => [p[0] + far[0], p[1] + far[1], p[2] + far[2]];
  const moved = edited((draft: Draft) => {
    for (const point of ["position", "target"]) draft.camera[point] = move(draft.camera[point]);
    for (const object of draft.objects) {
      for (const point of ["center", "point", "corner"]) if (object[point]) object[point] = move(object[point]);
      if (object.vertices) object.vertices = object.vertices.map(move);
    }
    for (const light of draft.lights) light.position = move(light.position);
  });
  const compiled = compile(moved);
  expect(compiled).toEqual({ ...compile(SCENE), origin: move(SCENE.camera.target) });
});

test("the uniform is as long as the struct that the shader declares", () => {
  const compiled = compile(SCENE);
  expect(unpack(compiled).bytes).toBe(compiled.uniform.byteLength);
  expect(unpack(compiled)).toMatchObject({ materials: { length: 9 }, shapes: { length: 9 }, lights: { length: 9 } });
});

test.each(REFERENCE_NAMES)("the uniform of %s is as long as its struct", async (name) => {
  const scene = parseScene(loadReference(name).scene);
  const settings = { estimator: "path", sampler: "sobol", lightSamples: 1 } as const;
  const compiled = compileScene(scene, settings, undefined, await prepareGeometry(scene));
  expect(unpack(compiled).bytes).toBe(compiled.uniform.byteLength);
});

test("every slot that the shader reads is there", () => {
  const compiled = compile(SCENE);
  const read = [...compiled.sceneModule.matchAll(/scene\.slots\[(\d+)\]/g)].map(([, slot]) => Number(slot));
  expect(Math.max(...read) + 1).toBe(unpack(compiled).slots.length);
  expect(new Set(read).size).toBe(unpack(compiled).slots.length);
});

test("a scene without objects has no array of length 0, which WGSL forbids", () => {
  const compiled = compile({ camera: { position: [0, 0, 1] }, objects: [] });
  expect(compiled.sceneModule).not.toMatch(/, 0>/);
  expect(unpack(compiled).bytes).toBe(compiled.uniform.byteLength);
});

test("a scene too large for a uniform is in a storage buffer", () => {
  const balls = (count: number) => ({
    camera: { position: [0, 0, 9] as const },
    materials: { white: {} },
    objects: Array.from({ length: count }, (_, i) => sphere({ center: [i, 0, 0], radius: 0.5, material: "white" })),
  });
  const [small, large] = [compile(balls(800)), compile(balls(900))];
  expect(small.uniform.byteLength).toBeLessThanOrEqual(65536);
  expect([small.isStored, large.isStored]).toEqual([false, true]);
  expect(small.sceneModule).toContain("var<uniform> scene");
  expect(large.sceneModule).toContain("var<storage, read> scene");
});
