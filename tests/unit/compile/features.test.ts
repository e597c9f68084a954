import { describe, expect, test } from "vitest";
import type { Features } from "../../../src/compile/features";
import { box, plane, pointLight, quad, sphere, sphereLight, triangle } from "../../../src/scene/builders";
import type { Light, Material, SceneObject, Vec3 } from "../../../src/scene/schema";
import { compile, sceneOf } from "../../support/compiled";

const BALL = (material: string) => sphere({ center: [0, 0, 0], radius: 1, material });
const FLOOR = (material: string) => plane({ point: [0, 0, 0], normal: [0, 1, 0], material });
const QUAD = (material: string) => quad({ corner: [0, 0, 0], edge1: [1, 0, 0], edge2: [0, 1, 0], material });
const VERTICES: readonly [Vec3, Vec3, Vec3] = [
  [0, 0, 0],
  [1, 0, 0],
  [0, 1, 0],
];
const TRIANGLE = (material: string) => triangle({ vertices: VERTICES, material });
const BOX = (material: string) => box({ center: [0, 0, 0], size: [1, 1, 1], material });
const BULB = sphereLight({ position: [0, 3, 0], radius: 0.1, power: [1, 1, 1] });
const POINT = pointLight({ position: [0, 3, 0], power: [1, 1, 1] });

function featuresOf(
  objects: readonly SceneObject[],
  lights: readonly Light[] = [],
  materials: Record<string, Material> = {},
): Features {
  return compile(sceneOf(objects, lights, materials)).features;
}

/** The features of a floor of this material. */
function surfaceFeatures(material: Material): Features {
  return featuresOf([FLOOR("it")], [], { it: material });
}

const LOBES = ["DIFFUSE", "SPECULAR", "ROUGH", "MIRROR", "SMITH", "SCHLICK_BECKMANN", "MULTISCATTER", "LOBES"] as const;

describe("lobes", () => {
  test.each<[string, Material, (typeof LOBES)[number][]]>([
    ["a dielectric without an interface", { ior: 1 }, ["DIFFUSE"]],
    ["a dielectric without an interface, and smooth", { ior: 1, roughness: 0 }, ["DIFFUSE"]],
    ["the default material", {}, ["DIFFUSE", "SPECULAR", "ROUGH", "SMITH", "LOBES"]],
    ["a polished dielectric", { roughness: 0 }, ["DIFFUSE", "SPECULAR", "MIRROR", "LOBES"]],
    ["a rough metal", { metallic: 1 }, ["SPECULAR", "ROUGH", "SMITH"]],
    ["a mirror", { metallic: 1, roughness: 0 }, ["SPECULAR", "MIRROR"]],
    ["all but a mirror: rougher in name only", { metallic: 1, roughness: 1e-4 }, ["SPECULAR", "MIRROR"]],
    ["a metal of ior 1", { metallic: 1, ior: 1 }, ["SPECULAR", "ROUGH", "SMITH"]],
    ["half a metal of ior 1", { metallic: 0.5, ior: 1 }, ["DIFFUSE", "SPECULAR", "ROUGH", "SMITH", "LOBES"]],
    ["Schlick's masking", { metallic: 1, masking: "schlick-beckmann" }, ["SPECULAR", "ROUGH", "SCHLICK_BECKMANN"]],
    [
      "Schlick's masking on a mirror, which has none",
      { metallic: 1, roughness: 0, masking: "schlick-beckmann" },
      ["SPECULAR", "MIRROR"],
    ],
    ["Schlick's masking without an interface", { ior: 1, masking: "schlick-beckmann" }, ["DIFFUSE"]],
    ["multiple scattering", { metallic: 1, multiscatter: true }, ["SPECULAR", "ROUGH", "SMITH", "MULTISCATTER"]],
    [
      "multiple scattering on a mirror, which has none",
      { metallic: 1, roughness: 0, multiscatter: true },
      ["SPECULAR", "MIRROR"],
    ],
    [
      "multiple scattering on a dielectric, which keeps glTF's",
      { multiscatter: true },
      ["DIFFUSE", "SPECULAR", "ROUGH", "SMITH", "LOBES"],
    ],
  ])("%s", (_, material, expected) => {
    const features = surfaceFeatures(material);
    expect(LOBES.filter((lobe) => features[lobe])).toEqual(expected);
  });

  test("are those of all materials together", () => {
    const materials: Record<string, Material> = {
      mirror: { metallic: 1, roughness: 0 },
      old: { metallic: 1, masking: "schlick-beckmann" },
      smith: { metallic: 1 },
    };
    const features = featuresOf(["mirror", "old", "smith"].map(BALL), [], materials);
    expect(features).toMatchObject({ DIFFUSE: false, LOBES: false });
    expect(features).toMatchObject({ SPECULAR: true, ROUGH: true, MIRROR: true, SMITH: true, SCHLICK_BECKMANN: true });
  });

  test("materials that no object uses contribute nothing", () => {
    const unused: Record<string, Material> = {
      mirror: { metallic: 1, roughness: 0 },
      old: { metallic: 1, masking: "schlick-beckmann" },
      glow: { emission: [1, 1, 1] },
    };
    expect(featuresOf([BALL("lambert")], [], unused)).toEqual(featuresOf([BALL("lambert")]));
  });

  test("the black body of a sphere light switches no lobe on", () => {
    const metal: Record<string, Material> = { metal: { metallic: 1 } };
    expect(featuresOf([BALL("metal")], [BULB], metal)).toMatchObject({ DIFFUSE: false, SPECULAR: true });
  });

  test("a scene of lights alone still has a lobe to compile", () => {
    expect(featuresOf([], [BULB])).toMatchObject({ DIFFUSE: true, SPECULAR: false });
  });
});

test("shapes are those of the objects; a sphere light is a sphere", () => {
  const shapes = ({ BALLS, SOLIDS }: Features) => ({ BALLS, SOLIDS });
  const none = { BALLS: false, SOLIDS: false };
  expect(shapes(featuresOf([FLOOR("lambert"), QUAD("lambert")]))).toEqual(none);
  expect(shapes(featuresOf([BALL("lambert")]))).toEqual({ ...none, BALLS: true });
  expect(shapes(featuresOf([BOX("lambert")]))).toEqual({ ...none, SOLIDS: true });
  expect(shapes(featuresOf([TRIANGLE("lambert")]))).toEqual(none);
  expect(shapes(featuresOf([FLOOR("lambert")], [BULB]))).toEqual({ ...none, BALLS: true });
  expect(shapes(featuresOf([FLOOR("lambert")], [POINT]))).toEqual(none);
});

const LIGHTS = ["EMISSION", "EMISSIVE_BALLS", "LIGHTS"] as const;

describe("lights", () => {
  const glow: Record<string, Material> = { glow: { ior: 1, emission: [1, 1, 1] } };

  test.each<[string, SceneObject[], Light[], (typeof LIGHTS)[number][]]>([
    ["none", [BALL("lambert")], [], []],
    ["a point", [], [POINT], ["LIGHTS"]],
    ["a sphere light", [], [BULB], ["EMISSION", "EMISSIVE_BALLS", "LIGHTS"]],
    ["a glowing sphere", [BALL("glow")], [], ["EMISSION", "EMISSIVE_BALLS", "LIGHTS"]],
    ["a glowing quad", [QUAD("glow")], [], ["EMISSION", "LIGHTS"]],
    ["a glowing box", [BOX("glow")], [], ["EMISSION", "LIGHTS"]],
    ["a glowing triangle", [TRIANGLE("glow")], [], ["EMISSION", "LIGHTS"]],
    ["a glowing plane, which has no area to sample", [FLOOR("glow")], [], ["EMISSION"]],
    ["a glowing quad and a point", [QUAD("glow")], [POINT], ["EMISSION", "LIGHTS"]],
  ])("%s", (_, objects, lights, expected) => {
    const features = featuresOf(objects, lights, glow);
    expect(LIGHTS.filter((light) => features[light])).toEqual(expected);
  });

  test("a light turned down to 0 keeps its features", () => {
    const dark = { ...BULB, power: [0, 0, 0] } as const;
    expect(featuresOf([FLOOR("lambert")], [dark])).toEqual(featuresOf([FLOOR("lambert")], [BULB]));
  });
});

test("an environment that is black is none", () => {
  const scene = sceneOf([BALL("lambert")]);
  expect(compile(scene).features.ENVIRONMENT).toBe(false);
  expect(compile({ ...scene, environment: { radiance: [0, 0, 0] } }).features.ENVIRONMENT).toBe(false);
  expect(compile({ ...scene, environment: { radiance: [0, 0, 0.1] } }).features.ENVIRONMENT).toBe(true);
});

test("settings choose the estimator, the sampler and the loop over light samples", () => {
  const scene = sceneOf([BALL("lambert")], [BULB]);
  expect(compile(scene).features).toMatchObject({ UNIFORM: false, SOBOL: true, MANY_LIGHT_SAMPLES: false });
  expect(compile(scene, { estimator: "uniform" }).features.UNIFORM).toBe(true);
  expect(compile(scene, { sampler: "independent" }).features.SOBOL).toBe(false);
  expect(compile(scene, { lightSamples: 2 }).features.MANY_LIGHT_SAMPLES).toBe(true);
});

test("the description names multiple scattering", () => {
  const materials = { it: { metallic: 1, multiscatter: true }, other: { metallic: 1 } };
  const { description } = compile(sceneOf([BALL("it"), BALL("other")], [], materials));
  expect(description).toEqual([
    "2 × sphere",
    "GGX",
    "Smith masking",
    "multiple scattering",
    "Sobol points",
    "values in a buffer",
  ]);
});

test("the description names what the shader contains, and counts it", () => {
  const objects = [FLOOR("lambert"), BALL("mirror"), BALL("lambert"), QUAD("glow")];
  const materials: Record<string, Material> = {
    mirror: { metallic: 1, roughness: 0 },
    glow: { ior: 1, emission: [1, 1, 1] },
  };
  expect(compile(sceneOf(objects, [POINT, POINT], materials)).description).toEqual([
    "plane",
    "2 × sphere",
    "quad",
    "diffuse",
    "mirror",
    "quad light",
    "2 × point light",
    "Sobol points",
    "values in a buffer",
  ]);
});
