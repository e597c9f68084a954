import { expect, test } from "vitest";
import { parseScene } from "../../../src/scene/parseScene";
import type { Scene, SceneObject } from "../../../src/scene/schema";
import { prepareGeometry } from "../../../src/tree/geometry";
import { cube, meshObject, placed, smoothSphere } from "../../support/meshes";

const scene = (changes: Partial<Scene> = {}): Scene => ({
  camera: { position: [0, 0, 5], target: [1, 0, 0] },
  materials: { m: {}, glow: { emission: [1, 1, 1] } },
  objects: [meshObject(cube(), "m"), meshObject(placed(smoothSphere(100), 1, [3, 0, 0]), "m")],
  ...changes,
});
const prepare = (input: Scene, previous?: Awaited<ReturnType<typeof prepareGeometry>>) =>
  prepareGeometry(parseScene(input), { previous });

test("a scene without meshes, and with few shapes, has none", async () => {
  const ball = (x: number) => ({ type: "sphere", center: [x, 0, 0], radius: 0.1, material: "m" }) as const;
  expect(await prepare(scene({ objects: [ball(0)] }))).toBeUndefined();
  const many = await prepare(scene({ objects: Array.from({ length: 60 }, (_, i) => ball(i)) }));
  expect(many?.shapes.size).toBe(60);
});

test("another material or camera position needs no other geometry, another target or vertex does", async () => {
  const before = await prepare(scene());
  const red = scene({ materials: { m: { baseColor: [1, 0, 0] }, glow: {} } });
  expect(await prepare(red, before)).toBe(before);
  expect(await prepare(scene({ camera: { position: [9, 9, 9], target: [1, 0, 0] } }), before)).toBe(before);
  expect(await prepare(scene({ camera: { position: [0, 0, 5], target: [2, 0, 0] } }), before)).not.toBe(before);
  const moved = [meshObject(placed(cube(), 1, [0, 0.5, 0]), "m"), scene().objects[1]!];
  expect(await prepare(scene({ objects: moved }), before)).not.toBe(before);
});

test("another second set of texture coordinates is another geometry", async () => {
  const withSet = (u: number) => {
    const [first, second] = scene().objects;
    const uvs1 = new Float32Array((2 * cube().positions.length) / 3).fill(u);
    return scene({ objects: [{ ...first!, uvs1 } as SceneObject, second!] });
  };
  const before = await prepare(withSet(0.5));
  expect(await prepare(withSet(0.5), before)).toBe(before);
  expect(await prepare(withSet(0.25), before)).not.toBe(before);
  expect(await prepare(scene(), before)).not.toBe(before);
});

test("the same texels in another array need no other geometry, a changed texel does", async () => {
  const textured = (texels: Uint8Array) => scene({ textures: { t: { width: 2, height: 1, texels } } });
  const texels = Uint8Array.of(1, 2, 3, 4, 5, 6, 7, 8);
  const before = (await prepare(textured(texels)))!;
  expect(before.data.texels).toEqual([texels]);
  expect(await prepare(textured(texels.slice()), before)).toBe(before);
  expect(await prepare(textured(new Uint8Array([0, ...texels]).subarray(1)), before)).toBe(before);
  expect(await prepare(textured(Uint8Array.of(1, 2, 3, 4, 5, 6, 7, 9)), before)).not.toBe(before);
  expect(await prepare(scene(), before)).not.toBe(before);
});

test("a mesh that begins to glow gets its table of triangles, and the tree stays", async () => {
  const before = (await prepare(scene()))!;
  const glowing = [meshObject(cube(), "glow"), scene().objects[1]!];
  const after = (await prepare(scene({ objects: glowing }), before))!;
  expect(after.data.nodes).toBe(before.data.nodes);
  expect(after.lights.get(0)).toMatchObject({ first: 0, count: 12, area: 24 });
  expect(after.data.emissiveTriangles?.byteLength).toBe(16 * 12);
});

test("vertices are relative to the target, and exact far from the origin", async () => {
  const far = scene({
    camera: { position: [1e6, 0, 5], target: [1e6, 0, 0] },
    objects: [meshObject(placed(cube(), 0.1, [1e6, 0, 0]), "m")],
  });
  const [part] = (await prepare(far))!.parts;
  expect(part!.lower[0]).toBeCloseTo(-0.1, 8);
  expect(part!.upper[0]).toBeCloseTo(0.1, 8);
});
