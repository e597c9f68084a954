import { describe, expect, test } from "vitest";
import { linkModule } from "../../../src/compile/linkProgram";
import { box, plane, pointLight, quad, sphere, sphereLight, triangle } from "../../../src/scene/builders";
import type { Light, Material, SceneObject } from "../../../src/scene/schema";
import { sceneOf, wgslOf } from "../../support/compiled";

const FLOOR = plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "it" });
const BULB = sphereLight({ position: [0, 3, 0], radius: 0.1, power: [1, 1, 1] });
const POINT = pointLight({ position: [0, 3, 0], power: [1, 1, 1] });

/** The names of the functions that a scene's shader contains. */
async function functionsOf(
  objects: readonly SceneObject[],
  lights: readonly Light[] = [],
  it: Material = { ior: 1 },
  settings: Parameters<typeof wgslOf>[1] = {},
): Promise<string[]> {
  const wgsl = await wgslOf(sceneOf(objects, lights, { it }), settings);
  return [...wgsl.matchAll(/\bfn (\w+)/g)].map(([, name]) => name!);
}

describe("the shader contains only what the scene needs", () => {
  test("Lambert surfaces need no microfacets, no Fresnel term and no choice of lobe", async () => {
    const functions = await functionsOf([FLOOR], [BULB]);
    expect(functions.filter((name) => /ggx|schlick|mirror|glossy/i.test(name))).toEqual([]);
    expect(functions).toContain("cosineHemisphere");
  });

  test("rough metals need no diffuse lobe and no other masking", async () => {
    const functions = await functionsOf([FLOOR], [BULB], { metallic: 1 });
    expect(functions).toEqual(expect.arrayContaining(["ggxSample", "ggxVisibility"]));
    for (const name of ["cosineHemisphere", "schlickBeckmannVisibility", "mirrorSample"]) {
      expect(functions).not.toContain(name);
    }
  });

  test("Schlick's masking replaces Smith's", async () => {
    const functions = await functionsOf([FLOOR], [BULB], { metallic: 1, masking: "schlick-beckmann" });
    expect(functions).toContain("schlickBeckmannVisibility");
    expect(functions).not.toContain("ggxVisibility");
  });

  test("multiple scattering is there only for rough metals that ask for it", async () => {
    const multiscatter = true;
    const rough = await functionsOf([FLOOR], [BULB], { metallic: 1, multiscatter });
    expect(rough).toContain("multiscatterGain");
    for (const material of [{ metallic: 1 }, { multiscatter }, { metallic: 1, roughness: 0, multiscatter }]) {
      expect((await functionsOf([FLOOR], [BULB], material)).filter((name) => /multiscatter/.test(name))).toEqual([]);
    }
  });

  test("mirrors need no microfacets", async () => {
    const functions = await functionsOf([FLOOR], [BULB], { metallic: 1, roughness: 0 });
    expect(functions).toContain("mirrorSample");
    expect(functions.filter((name) => /ggx|glossy/i.test(name))).toEqual([]);
  });

  const INTERSECTORS: Record<string, [RegExp, SceneObject]> = {
    plane: [/planeIntersect/, plane({ point: [0, 0, 0], normal: [0, 1, 0.5], material: "it" })],
    sphere: [/sphereIntersect/, sphere({ center: [0, 0, 0], radius: 1, material: "it" })],
    box: [/boxIntersect/i, box({ center: [0, 0, 0], size: [1, 1, 1], material: "it" })],
    quad: [/quadIntersect/, quad({ corner: [0, 0, 0], edge1: [1, 0, 0], edge2: [0, 1, 0], material: "it" })],
    triangle: [
      /triangleIntersect|shearOf/,
      triangle({
        vertices: [
          [0, 0, 0],
          [1, 0, 0],
          [0, 1, 0],
        ],
        material: "it",
      }),
    ],
  };
  // A quad meets the plane it lies in first.
  const IMPLIED: Record<string, string[]> = { quad: ["plane"] };

  test.each(Object.keys(INTERSECTORS))("a scene of one %s intersects nothing else", async (kind) => {
    const functions = await functionsOf([INTERSECTORS[kind]![1]], [POINT]);
    for (const [other, [pattern]] of Object.entries(INTERSECTORS)) {
      if (IMPLIED[kind]?.includes(other)) continue;
      expect(
        functions.some((name) => pattern.test(name)),
        other,
      ).toBe(other === kind);
    }
  });

  test("a scene without lights samples none and casts no shadow rays", async () => {
    const functions = await functionsOf([FLOOR]);
    expect(functions.filter((name) => /light|occluded|between|heuristic/i.test(name))).toEqual([]);
  });

  test("one kind of light brings one way to sample it", async () => {
    const samplers = async (lights: Light[], it: Material = { ior: 1 }) =>
      (await functionsOf([FLOOR, INTERSECTORS.quad![1]], lights, it)).filter((name) =>
        /^sample(?!Light|Kind)/.test(name),
      );
    expect(await samplers([BULB])).toEqual(["sampleSphere"]);
    expect(await samplers([POINT])).toEqual(["samplePosition"]);
    expect(await samplers([], { ior: 1, emission: [1, 1, 1] })).toEqual(["samplePlanar"]);
    expect((await samplers([BULB, POINT])).sort()).toEqual(["samplePosition", "sampleSphere"]);
  });

  test("independent points need no Sobol sequence", async () => {
    const sobol = (names: string[]) => names.filter((name) => /sobol|scramble/i.test(name)).length;
    expect(sobol(await functionsOf([FLOOR], [BULB]))).toBeGreaterThan(0);
    expect(sobol(await functionsOf([FLOOR], [BULB], { ior: 1 }, { sampler: "independent" }))).toBe(0);
  });

  test("the baseline needs no multiple importance sampling", async () => {
    const functions = await functionsOf([FLOOR], [BULB], {}, { estimator: "uniform" });
    expect(functions).toContain("uniformHemisphere");
    for (const name of ["powerHeuristic", "bsdfSample", "sampleSphere"]) expect(functions).not.toContain(name);
  });
});

test.each([
  { estimator: "path", lamps: 1, entryPoints: ["trace", "traceEmitters"] },
  { estimator: "path", lamps: 0, entryPoints: ["trace"] },
  { estimator: "uniform", lamps: 1, entryPoints: ["trace"] },
] as const)("with $lamps lamps, $estimator is plain WGSL with the entry points $entryPoints", async (program) => {
  const lights = program.lamps > 0 ? [BULB] : [pointLight({ position: [0, 3, 0], power: [1, 1, 1] })];
  const wgsl = await wgslOf(sceneOf([FLOOR], lights, { it: {} }), { estimator: program.estimator });
  const code = wgsl.replaceAll(/\/\/.*/g, "");
  expect(code).not.toMatch(/@if|@else|\bimport\b|package::/);
  expect([...code.matchAll(/@compute[^{]*?fn (\w+)/g)].map(([, name]) => name).sort()).toEqual(program.entryPoints);
});

test("no function is declared twice", async () => {
  const functions = await functionsOf([FLOOR, sphere({ center: [0, 0, 0], radius: 1, material: "it" })], [BULB], {});
  expect(functions).toEqual([...new Set(functions)]);
});

test.each(["blit", "error"])("the module %s links without a scene", async (module) => {
  const wgsl = await linkModule(module);
  expect(wgsl).toMatch(/@(fragment|compute)/);
  expect(wgsl.replaceAll(/\/\/.*/g, "")).not.toMatch(/@if|\bimport\b|package::/);
});

test("linking twice gives the same text", async () => {
  const scene = sceneOf([FLOOR], [BULB], { it: {} });
  expect(await wgslOf(scene)).toBe(await wgslOf(scene));
});
