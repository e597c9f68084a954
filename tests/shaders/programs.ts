import { afterAll, describe, expect, test } from "vitest";
import { compileScene } from "../../src/compile/compileScene";
import type { ProgramSettings } from "../../src/compile/features";
import { linkProgram } from "../../src/compile/linkProgram";
import { parseScene } from "../../src/scene/parseScene";
import type { Light, Material, Scene, SceneObject } from "../../src/scene/schema";
import { prepareGeometry } from "../../src/tree/geometry";
import { loadReference, REFERENCE_NAMES } from "../support/reference";
import { diagnose, diagnosePipeline, releaseTint } from "../support/tint";

export const PRIMITIVES: Readonly<Record<string, SceneObject>> = {
  "a sphere": { type: "sphere", center: [0, 1, 0], radius: 1, material: "m" },
  "a level plane": { type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material: "m" },
  "an upright plane": { type: "plane", point: [0, 0, -1], normal: [0, 0, 2], material: "m" },
  "a plane across x": { type: "plane", point: [-1, 0, 0], normal: [1, 0, 0], material: "m" },
  "a tilted plane": { type: "plane", point: [0, 0, 0], normal: [0.1, 1, 0.2], material: "m" },
  "a quad across x": { type: "quad", corner: [0, 0, 0], edge1: [0, 1, 0], edge2: [0, 0, 1], material: "m" },
  "a quad across y": { type: "quad", corner: [0, 0, 0], edge1: [0, 0, 1], edge2: [1, 0, 0], material: "m" },
  "a quad across z": { type: "quad", corner: [0, 0, 0], edge1: [1, 0, 0], edge2: [0, 1, 0], material: "m" },
  "a skewed quad": { type: "quad", corner: [0, 0, 0], edge1: [1, 0.1, 0], edge2: [0.2, 1, 0.3], material: "m" },
  "a triangle": {
    type: "triangle",
    vertices: [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
    ],
    material: "m",
  },
  "a triangle without area": {
    type: "triangle",
    vertices: [
      [0, 0, 0],
      [1, 0, 0],
      [2, 0, 0],
    ],
    material: "m",
  },
  "a box": { type: "box", center: [0, 1, 0], size: [1, 2, 3], material: "m" },
  "a turned box": { type: "box", center: [0, 1, 0], size: [1, 2, 3], rotationY: 30, material: "m" },
};

export const MATERIALS: Readonly<Record<string, Material>> = {
  Lambert: { ior: 1 },
  plastic: {},
  "rough metal": { metallic: 1, roughness: 0.4 },
  "half metal": { metallic: 0.5, roughness: 0.4 },
  "half metal with multiple scattering": { metallic: 0.5, roughness: 0.4, multiscatter: true },
  mirror: { metallic: 1, roughness: 0 },
  "polished plastic": { roughness: 0 },
  "Schlick–Beckmann": { metallic: 1, roughness: 0.4, masking: "schlick-beckmann" },
  "Schlick–Beckmann plastic": { roughness: 0.4, masking: "schlick-beckmann" },
  "a clear wall": { transmission: 1, roughness: 0 },
  "a coloured clear wall": { transmission: 0.5, roughness: 0, baseColor: [1, 0.5, 0.2] },
  "a rough wall": { transmission: 1, roughness: 0.5 },
  "a rough wall without an interface": { transmission: 1, roughness: 0.5, ior: 1 },
  glass: { transmission: 1, roughness: 0, thickness: 1 },
  "rough glass": { transmission: 1, roughness: 0.5, thickness: 1 },
  "coloured glass": {
    transmission: 0.9,
    roughness: 0,
    thickness: 1,
    attenuationColor: [1, 0.5, 0],
    attenuationDistance: 1,
  },
  "a prism": { transmission: 1, roughness: 0.2, thickness: 1, dispersion: 1 },
  paper: { diffuseTransmission: 0.5, diffuseTransmissionColor: [1, 0.5, 0] },
  "paper of ior 1": { diffuseTransmission: 1, ior: 1 },
  wax: { diffuseTransmission: 0.5, thickness: 1, attenuationColor: [1, 0.5, 0], attenuationDistance: 1 },
  "a tinted reflection": { specular: 0.5, specularColor: [1, 0.5, 0] },
  velvet: { sheenColor: [1, 0.5, 0], sheenRoughness: 0.5 },
  "velvet without an interface": { sheenColor: [1, 0.5, 0], ior: 1 },
  "lacquer on nothing": { clearcoat: 1, ior: 1 },
  "rough lacquer on paper without an interface": {
    clearcoat: 1,
    clearcoatRoughness: 0.5,
    ior: 1,
    diffuseTransmission: 0.5,
  },
  lacquer: { clearcoat: 1, emission: [1, 1, 1] },
  "rough lacquer on velvet on glass": {
    ...{
      clearcoat: 0.5,
      clearcoatRoughness: 0.3,
      sheenColor: [1, 1, 1],
      transmission: 0.5,
      roughness: 0,
      thickness: 1,
    },
  },
  "brushed metal": { metallic: 1, roughness: 0.4, anisotropy: 0.7, anisotropyRotation: 30 },
  "brushed glass": { transmission: 1, roughness: 0.4, anisotropy: 0.7, thickness: 1 },
  "a soap film": { iridescence: 1, roughness: 0 },
  "a film on rough glass": { iridescence: 0.5, roughness: 0.5, transmission: 1, thickness: 1 },
  "glowing Lambert": { ior: 1, emission: [1, 1, 1] },
  "glowing metal": { metallic: 1, roughness: 0.4, emission: [1, 1, 1] },
  "glowing mirror": { metallic: 1, roughness: 0, emission: [1, 1, 1] },
};

export const LIGHTS: Readonly<Record<string, Light[]>> = {
  "no light": [],
  "a point light": [{ type: "point", position: [0, 3, 0], power: [1, 1, 1] }],
  "a sphere light": [{ type: "sphere", position: [0, 3, 0], radius: 0.1, power: [1, 1, 1] }],
  "a spot, a sun and a sphere light": [
    { type: "spot", position: [0, 3, 0], direction: [0, -1, 0], power: [1, 1, 1] },
    { type: "directional", direction: [0, -1, 0], irradiance: [1, 1, 1], angularDiameter: 0.53 },
    { type: "sphere", position: [1, 3, 0], radius: 0.1, power: [1, 1, 1] },
  ],
  "a dark sphere light": [{ type: "sphere", position: [0, 3, 0], radius: 0.1, power: [0, 0, 0] }],
  "lights of both kinds": [
    { type: "point", position: [0, 3, 0], power: [1, 1, 1] },
    { type: "sphere", position: [1, 3, 0], radius: 0.1, power: [1, 1, 1] },
  ],
};

/** Those that are tried with one material only. */
const DIRECTED_LIGHTS: Readonly<Record<string, Light[]>> = {
  "a point of a sun": [{ type: "directional", direction: [0, -1, 0], irradiance: [1, 1, 1] }],
  "a sun": [{ type: "directional", direction: [0, -1, 0], irradiance: [1, 1, 1], angularDiameter: 0.53 }],
  "two suns": [
    { type: "directional", direction: [0, -1, 0], irradiance: [1, 1, 1], angularDiameter: 0.53 },
    { type: "directional", direction: [1, -1, 0], irradiance: [1, 1, 1] },
  ],
  "a spot": [{ type: "spot", position: [0, 3, 0], direction: [0, -1, 0], power: [1, 1, 1] }],
};

const FULLY_LIT = ["a sphere", "a tilted plane"];

const TEXTURE = { width: 1, height: 1, texels: [200, 100, 150, 255] } as const;
const TEXTURES = {
  baseColorTexture: "t",
  metallicRoughnessTexture: "t",
  emissionTexture: "t",
  normalTexture: "t",
} as const;

const PLACED = { texture: "t", uv: 1, scale: [2, -1], rotation: 30 } as const;

const many = <T>(count: number, one: (i: number) => T) => Array.from({ length: count }, (_, i) => one(i));
const NAMES = ["Lambert", "plastic", "rough metal"];
const ball = (i: number): SceneObject => {
  return { type: "sphere", center: [i % 64, Math.floor(i / 64), 0], radius: 0.4, material: NAMES[i % 3]! };
};

/** Scenes of more than is written out in a program. */
export const CROWDS: Readonly<Record<string, { readonly objects: SceneObject[]; readonly lights: Light[] }>> = {
  "4,096 spheres in three materials": { objects: many(4096, ball), lights: LIGHTS["a point light"]! },
  "1,100 meshes in two materials": {
    objects: many(1100, (i) => {
      return { type: "mesh", positions: [i, 0, 0, i + 1, 0, 0, i, 1, 0], indices: [0, 1, 2], material: NAMES[i % 2]! };
    }),
    lights: LIGHTS["a sphere light"]!,
  },
  "200 planes": {
    objects: many(200, (i) => ({ ...PRIMITIVES["a tilted plane"]!, point: [0, -i, 0], material: NAMES[i % 3]! })),
    lights: LIGHTS["lights of both kinds"]!,
  },
  "50 planes, 30 huge spheres that shine and 100 lights": {
    objects: [
      ...many(50, (i) => ({ ...PRIMITIVES["a level plane"]!, point: [0, -i, 0] }) as SceneObject),
      ...many(30, (i): SceneObject => {
        return { type: "sphere", center: [0, -1e5 - i, 0], radius: 1e5, material: "glowing Lambert" };
      }),
      ...many(50, ball),
    ],
    lights: many(100, (i) => ({ type: "sphere", position: [i, 9, 0], radius: 0.1, power: [1, 1, 1] })),
  },
  "100 triangles without area": {
    objects: many(100, () => PRIMITIVES["a triangle without area"]!),
    lights: LIGHTS["a point light"]!,
  },
};

/** Compiles what an estimator makes of scenes of every kind: a file of tests for each, so that they run side by side. */
export function describePrograms(settings: ProgramSettings): void {
  afterAll(() => releaseTint());

  describe.each(
    (["sobol", "independent"] as const).flatMap((sampler) =>
      [1, 4].map((lightSamples): ProgramSettings => ({ ...settings, sampler, lightSamples })),
    ),
  )("$sampler points, $lightSamples light samples", (each) => {
    test.each(REFERENCE_NAMES)("%s compiles without a warning", async (name) => {
      await expectGood(loadReference(name).scene, each);
    });
  });

  describe.each(Object.keys(PRIMITIVES))("%s", (primitive) => {
    // What materials make of light does not depend on the shape: all lights shine on one that is curved and one that is flat.
    const lights = FULLY_LIT.includes(primitive) ? Object.keys(LIGHTS) : ["no light", "lights of both kinds"];
    test.each(Object.keys(MATERIALS))(
      `of %s compiles without a warning, with ${lights.join(", ")}`,
      async (material) => {
        for (const name of lights) {
          for (const radiance of [
            [0, 0, 0],
            [1, 1, 1],
          ] as const) {
            const scene = sceneOf([PRIMITIVES[primitive]!], { m: MATERIALS[material]! }, LIGHTS[name]!, radiance);
            await expectGood(scene, settings);
          }
        }
      },
    );
  });

  test.each(Object.keys(LIGHTS))("an empty scene with %s compiles without a warning", async (light) => {
    await expectGood(sceneOf([], {}, LIGHTS[light]!, [0, 0, 0]), settings);
    await expectGood(sceneOf([], {}, LIGHTS[light]!, [1, 1, 1]), settings);
  });

  test.each(Object.keys(DIRECTED_LIGHTS))("plastic under %s compiles without a warning", async (light) => {
    for (const radiance of [
      [0, 0, 0],
      [1, 1, 1],
    ] as const) {
      await expectGood(
        sceneOf([PRIMITIVES["a sphere"]!], { m: MATERIALS.plastic! }, DIRECTED_LIGHTS[light]!, radiance),
        settings,
      );
    }
  });

  test("everything at once compiles without a warning", async () => {
    const names = Object.keys(MATERIALS);
    const objects = Object.values(PRIMITIVES).flatMap((object) => names.map((material) => ({ ...object, material })));
    await expectGood(sceneOf(objects, MATERIALS, LIGHTS["lights of both kinds"]!, [1, 1, 1]), settings);
  });

  test("a lens compiles without a warning, before lamps, meshes and alpha", async () => {
    const m: Material = { alpha: 0.5, alphaMode: "blend" };
    for (const scene of meshScenes(m)) {
      await expectGood({ ...scene, camera: { ...scene.camera, aperture: 0.1 } }, settings);
    }
  });

  test.each(Object.keys(CROWDS))("%s compile without a warning", async (name) => {
    const { objects, lights } = CROWDS[name]!;
    await expectGood(sceneOf(objects, { m: {}, ...MATERIALS }, lights, [1, 1, 1]), settings);
  });

  test.each(Object.keys(MATERIALS))("two materials, one of them %s, compile without a warning", async (first) => {
    const objects = [0, 1].map((i): SceneObject => ({ ...PRIMITIVES["a sphere"]!, material: ["a", "b"][i]! }));
    for (const second of Object.values(MATERIALS)) {
      await expectGood(sceneOf(objects, { a: MATERIALS[first]!, b: second }, [], [1, 1, 1]), settings);
    }
  });

  test.each(Object.keys(MATERIALS))(
    "a mesh of %s compiles without a warning, faceted, smooth and textured",
    async (name) => {
      for (const scene of meshScenes(MATERIALS[name]!)) await expectGood(scene, settings);
    },
  );

  test.each(Object.keys(MATERIALS))("a mesh of %s whose textures have places compiles without a warning", (name) =>
    expectGood(placedScene(MATERIALS[name]!), settings),
  );
}

/** Of a mesh of a material, faceted, smooth and textured, and a sphere. */
export function meshScenes(material: Material): Scene[] {
  const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0];
  const mesh = { type: "mesh", positions, indices: [0, 1, 2], material: "m" } as const;
  const textured = { ...mesh, uvs: [0, 0, 1, 0, 0, 1] };
  return [mesh, { ...mesh, normals: positions }, textured, { ...textured, normals: positions }].map((object): Scene => {
    const m = { ...material, ...("uvs" in object && TEXTURES) };
    const objects = [object, { ...PRIMITIVES["a sphere"]!, material: "n" }];
    return { ...sceneOf(objects, { m, n: {} }, LIGHTS["lights of both kinds"]!, [1, 1, 1]), textures: { t: TEXTURE } };
  });
}

/** Of a mesh of a material whose textures have places of their own, and a sphere. */
export function placedScene(material: Material): Scene {
  const [positions, uvs] = [
    [0, 0, 0, 1, 0, 0, 0, 1, 0],
    [0, 0, 1, 0, 0, 1],
  ];
  const tangents = [1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1];
  const mesh = { type: "mesh", positions, normals: positions, tangents, uvs, uvs1: uvs, indices: [0, 1, 2] } as const;
  const placed = Object.keys(TEXTURES).map((field) => [field, PLACED]);
  const objects = [
    { ...mesh, material: "m" },
    { ...PRIMITIVES["a sphere"]!, material: "n" },
  ];
  const materials = { m: { ...material, ...Object.fromEntries(placed) }, n: {} };
  return { ...sceneOf(objects, materials, LIGHTS["lights of both kinds"]!, [1, 1, 1]), textures: { t: TEXTURE } };
}

export function sceneOf(
  objects: readonly SceneObject[],
  materials: Readonly<Record<string, Material>>,
  lights: readonly Light[],
  radiance: readonly [number, number, number],
): Scene {
  return {
    camera: { position: [0, 1, 5] },
    materials: { ...materials },
    objects: [...objects],
    lights: [...lights],
    environment: { radiance },
  };
}

// Programs that differ in values only have the same text: compile each text once.
const good = new Set<string>();

async function expectGood(scene: Scene, settings: ProgramSettings): Promise<void> {
  const resolved = parseScene(scene);
  const geometry = await prepareGeometry(resolved);
  for (const camera of [undefined, resolved.camera]) {
    // Values in the uniform, then as constants.
    const { sceneModule, features } = compileScene(resolved, settings, camera, geometry);
    const key = JSON.stringify(features) + sceneModule;
    if (good.has(key)) continue;
    const wgsl = await linkProgram(sceneModule, features);
    expect(await diagnose(wgsl), JSON.stringify(features)).toEqual([]);
    expect(await diagnosePipeline(wgsl, "trace"), JSON.stringify(features)).toEqual([]);
    good.add(key);
  }
}
