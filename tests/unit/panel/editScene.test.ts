import { expect, it } from "vitest";
import { nameOf, objectsOf, partsOf, withLight, withMaterial } from "../../../src/panel/editScene";
import { plane, pointLight, sphere, sphereLight } from "../../../src/scene/builders";
import { parseScene } from "../../../src/scene/parseScene";
import type { ResolvedLight } from "../../../src/scene/schema";

const scene = parseScene({
  camera: { position: [0, 1, 5] },
  materials: { floor: {}, "<b>gold</b>": { metallic: 1 } },
  objects: [
    plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "floor" }),
    sphere({ center: [0, 1, 0], radius: 1, material: "<b>gold</b>" }),
    sphere({ center: [2, 1, 0], radius: 1, material: "<b>gold</b>" }),
  ],
  lights: [
    pointLight({ position: [0, 4, 0], power: [1, 1, 1] }),
    sphereLight({ position: [1, 4, 0], radius: 0.5, power: [1, 1, 1] }),
  ],
});

it("objects and then lights can be chosen, each by its place and what it is", () => {
  expect(partsOf(scene).map((part) => nameOf(scene, part))).toEqual([
    "objects[0] · plane · floor",
    "objects[1] · sphere · <b>gold</b>",
    "objects[2] · sphere · <b>gold</b>",
    "lights[0] · point",
    "lights[1] · sphere",
  ]);
  expect(objectsOf(scene, "<b>gold</b>")).toEqual(scene.objects.slice(1));
});

it("an edited scene is a valid one, differs in the one place, and leaves the first as it was", () => {
  const before = structuredClone(scene);
  const rough = withMaterial(scene, "<b>gold</b>", { ...scene.materials["<b>gold</b>"]!, roughness: 0.25 });
  expect(parseScene(rough).materials["<b>gold</b>"]).toMatchObject({ metallic: 1, roughness: 0.25 });
  expect(rough.materials.floor).toBe(scene.materials.floor);
  const bright = withLight(rough, 1, { ...scene.lights[1]!, power: [9, 9, 9] } as ResolvedLight);
  expect(parseScene(bright).lights).toMatchObject([{ power: [1, 1, 1] }, { power: [9, 9, 9], radius: 0.5 }]);
  expect(structuredClone(scene)).toEqual(before);
});
