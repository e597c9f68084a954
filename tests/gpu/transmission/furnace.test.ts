// Clear glass where the same light comes from everywhere: it cannot be seen.

import { describe, expect, test } from "vitest";
import type { Material, Scene, SceneObject } from "../../../src/scene/schema";
import { expectColor, look, meanColor } from "../../support/glass";
import { icosphere, meshObject, smoothSphere } from "../../support/meshes";

const material = "glass";
const GLASS: Material = { transmission: 1, thickness: 1, roughness: 0 };
const SKY = [0.5, 1, 2] as const;

const SOLIDS: Readonly<Record<string, SceneObject>> = {
  ball: { type: "sphere", center: [0, 0, 0], radius: 1, material },
  "turned box": { type: "box", center: [0, 0, 0], size: [1.4, 1.2, 1.3], rotationY: 30, material },
  "mesh with facets": meshObject(icosphere(1), material),
};

function furnace(object: SceneObject, glass: Material = GLASS): Scene {
  return {
    camera: { position: [0.3, 0.7, 4], target: [0, 0, 0], verticalFov: 32 },
    materials: { glass },
    objects: [object],
    environment: { radiance: SKY },
    maxBounces: 64,
  };
}

describe.each(Object.entries(SOLIDS))("a %s of smooth glass, seeds 1–4", (_name, object) => {
  // Paths that are totally reflected for ever are cut after 64 bounces: of these shapes, 0.02 % of the light at most, for what
  // is caught in a convex solid must have got in, and 4 % leaves at the least wherever it can. A box holds some light of
  // which none can leave through any face, but none of it gets in from outside.
  test.each(["path", "uniform"] as const)("is invisible, %s estimator", async (estimator) => {
    expectColor(await look(furnace(object), { settings: { estimator } }), SKY, 2e-4);
  });
});

test("a mesh with smooth normals loses no more than where its facets and its normals disagree, seeds 1–4", async () => {
  const { color } = meanColor(await look(furnace(meshObject(smoothSphere(1200), material))));
  // A direction on the one side of the normal and on the other of the facet goes nowhere. They differ by up to
  // π/24 here, half the angle between vertices, so that it happens within 0.13 of grazing: on the rim of the ball.
  for (const [i, value] of color.entries()) {
    expect(value / SKY[i]!).toBeLessThan(1 + 1e-3);
    expect(value / SKY[i]!).toBeGreaterThan(0.97);
  }
});

test.each([1.05, 1.33, 2.4])("a ball of ior %d is invisible, seeds 1–4", async (ior) => {
  expectColor(await look(furnace(SOLIDS.ball!, { ...GLASS, ior })), SKY, 2e-4);
});

test("dispersion takes and adds nothing, seeds 1–4", async () => {
  expectColor(await look(furnace(SOLIDS.ball!, { ...GLASS, dispersion: 1 })), SKY, 2e-4);
});

test("a ball in a ball is invisible, seeds 1–4", async () => {
  const inner: SceneObject = { type: "sphere", center: [0.2, 0, 0], radius: 0.5, material };
  const scene = furnace(SOLIDS.ball!);
  expectColor(await look({ ...scene, objects: [...scene.objects, inner] }), SKY, 2e-4);
});

test("glass seen from its inside is invisible, seeds 1–4", async () => {
  const scene = furnace(SOLIDS.ball!);
  const camera = { position: [0.2, 0.1, 0.3], target: [1, 0, 0], verticalFov: 60 } as const;
  expectColor(await look({ ...scene, camera }), SKY, 2e-4);
});
