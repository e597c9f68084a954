import { describe, expect, test } from "vitest";
import { box, plane, pointLight, quad, sphere, sphereLight, triangle } from "../../../src/scene/builders";
import type { Light, Material, SceneObject } from "../../../src/scene/schema";
import { compile, sceneOf, unpack } from "../../support/compiled";

const BALL = sphere({ center: [1, 2, 3], radius: 0.5, material: "it" });
const QUAD = quad({ corner: [0, 0, 0], edge1: [2, 0, 0], edge2: [0, 4, 0], material: "it" });

function pack(objects: readonly SceneObject[], lights: readonly Light[] = [], it: Material = { ior: 1 }) {
  return unpack(compile(sceneOf(objects, lights, { it })));
}

/** Numbers as f32 keeps them: the nearest of 24 bits. */
function f32(values: readonly number[]): unknown[] {
  return values.map((value) => Math.fround(value));
}

test("the environment comes first", () => {
  const scene = { ...sceneOf([]), environment: { radiance: [0.1, 2, 30] as const } };
  expect(unpack(compile(scene)).environment).toEqual([f32([0.1, 2, 30, 0])]);
});

describe("materials", () => {
  const packed = (material: Material) => pack([BALL], [], material).materials[0]!;
  /** In a table that has the columns of another material too. */
  const packedBeside = (other: Material, it: Material) => {
    const objects = [BALL, { ...BALL, material: "other" }];
    return unpack(compile(sceneOf(objects, [], { it, other }))).materials[0]!;
  };
  const baseColor = [0.5, 0.25, 0.125] as const;

  test("a surface without an interface is Lambert alone: no reflectance at any angle", () => {
    expect(packedBeside({}, { baseColor, ior: 1, roughness: 0.5 })).toMatchObject({
      diffuse: baseColor,
      F0: [0, 0, 0],
      f0: 0,
      f90: 0,
    });
  });

  test("a table has no column that its scene makes no use of", () => {
    expect(packed({ baseColor, ior: 1 })).toEqual({ diffuse: baseColor });
    expect(Object.keys(packed({ metallic: 1 })).sort()).toEqual(["F0", "alpha", "f0", "f90"]);
    expect(Object.keys(packed({ ior: 1, emission: [1, 1, 1] })).sort()).toEqual([
      "diffuse",
      "emission",
      "lightDensity",
    ]);
  });

  test("a dielectric reflects ((ior − 1)/(ior + 1))² at normal incidence, whatever its colour", () => {
    expect(packed({ baseColor, ior: 3 })).toMatchObject({
      diffuse: baseColor,
      F0: [0.25, 0.25, 0.25],
      f0: 0.25,
      f90: 1,
    });
  });

  test("a metal reflects its colour and has no diffuse part", () => {
    const metal = packedBeside({}, { baseColor, metallic: 1, ior: 3 });
    expect(metal).toMatchObject({ diffuse: [0, 0, 0], F0: baseColor, f90: 1 });
  });

  test("between the two everything is mixed", () => {
    const material = packed({ baseColor, metallic: 0.25, ior: 3 });
    expect(material).toMatchObject({
      diffuse: [0.375, 0.1875, 0.09375],
      F0: [0.3125, 0.25, 0.21875], // 0.75 · 0.25 + 0.25 · baseColor
      f0: 0.25,
    });
  });

  test.each([
    [1, 1],
    [0.5, 0.25],
    [0, 0],
  ])("roughness %d is α = %d", (roughness, alpha) => {
    expect(packed({ roughness })).toMatchObject({ alpha });
  });

  test("a roughness that tilts no direction by as much as f32 rounds it is a perfect mirror's", () => {
    expect(packed({ roughness: 2 ** -12 })).toMatchObject({ alpha: 2 ** -24 });
    for (const roughness of [2 ** -12.1, 1e-30]) expect(packed({ roughness })).toMatchObject({ alpha: 0 });
  });

  test("masking is a flag", () => {
    const schlickBeckmann: Material = { masking: "schlick-beckmann" };
    expect(packedBeside(schlickBeckmann, {})).toMatchObject({ schlickBeckmann: 0 });
    expect(packedBeside({}, schlickBeckmann)).toMatchObject({ schlickBeckmann: 1 });
  });

  test("multiple scattering is given back in proportion to the metal", () => {
    const white: Material = { metallic: 1, multiscatter: true };
    expect(packedBeside(white, { metallic: 0.5 })).toMatchObject({ multiscatter: 0 });
    expect(packedBeside(white, { metallic: 0.5, multiscatter: true })).toMatchObject({ multiscatter: 0.5 });
    expect(packedBeside(white, { multiscatter: true })).toMatchObject({ multiscatter: 0 });
  });

  test("emission is as written; a sphere light's body is black", () => {
    expect(packed({ emission: [1, 20, 0.5] })).toMatchObject({ emission: [1, 20, 0.5] });
    const light = sphereLight({ position: [0, 0, 0], radius: 1 / Math.PI, power: [4, 8, 12] });
    expect(pack([], [light]).materials).toEqual([
      expect.objectContaining({ diffuse: [0, 0, 0], emission: f32([1, 2, 3]) }),
    ]);
  });

  test("two objects of one material have a row each", () => {
    expect(pack([BALL, QUAD], [], { baseColor, ior: 1 }).materials).toMatchObject([
      { diffuse: baseColor },
      { diffuse: baseColor },
    ]);
  });
});

describe("the density of light sampling", () => {
  const glow: Material = { ior: 1, emission: [1, 1, 1] };
  const densityOf = (object: SceneObject) => pack([object], [], glow).materials[0]!.lightDensity;
  const dark = plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "lambert" });

  test("is 0 on what does not emit", () => {
    expect(pack([dark, QUAD], [], glow).materials[0]).toMatchObject({ lightDensity: 0 });
  });

  test("is per area on flat emitters", () => {
    expect(densityOf(QUAD)).toBe(1 / 8);
    const vertices = [
      [0, 0, 0],
      [2, 0, 0],
      [0, 2, 0],
    ] as const;
    expect(densityOf(triangle({ vertices, material: "it" }))).toBe(1 / 2);
    // Six lights, each as strong as the strongest: 6 over 24 m².
    expect(densityOf(box({ center: [0, 0, 0], size: [2, 2, 2], material: "it" }))).toBeCloseTo(1 / 4, 7);
  });

  test("is 1 on a lone sphere, whose cone is sampled", () => {
    expect(densityOf(BALL)).toBe(1);
  });

  test("is 0 on an infinite plane, which is never sampled", () => {
    expect(densityOf(plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "it" }))).toBe(0);
  });

  test("is 0 on a triangle without area", () => {
    const vertices = [
      [0, 0, 0],
      [1, 0, 0],
      [2, 0, 0],
    ] as const;
    expect(densityOf(triangle({ vertices, material: "it" }))).toBe(0);
  });

  test("holds the light's strength where there are several, for the shader to weigh", () => {
    const point = pointLight({ position: [0, 9, 0], power: [5, 5, 5] });
    expect(pack([QUAD], [point], glow).materials[0]!.lightDensity).toBe(1 / 8); // the strongest, over 8 m²
    const stronger = pointLight({ position: [0, 9, 0], power: [4 * Math.PI, 4 * Math.PI, 4 * Math.PI] });
    expect(pack([BALL], [stronger], glow).materials[0]!.lightDensity).toBeCloseTo(Math.PI * 0.5 ** 2, 6);
  });
});

test("a shape is a sphere's centre and radius, or a flat primitive's unit normal and 0", () => {
  const slanted = plane({ point: [7, 7, 7], normal: [0, 3, 4], material: "it" });
  expect(pack([BALL, slanted, QUAD]).shapes).toEqual([[1, 2, 3, 0.5], f32([0, 0.6, 0.8, 0]), [0, 0, 1, 0]]);
});

test("a box is told by its fourth component, -1: its normal depends on the point", () => {
  expect(pack([box({ center: [5, 5, 5], size: [1, 1, 1], material: "it" })]).shapes[0]![3]).toBe(-1);
});

describe("lights", () => {
  test("have numbers by kind, which the program compares with, in their order", () => {
    const glow = { glow: { ior: 1, emission: [1, 1, 1] } } as const;
    const compiled = compile(
      sceneOf(
        [{ ...QUAD, material: "glow" }],
        [
          sphereLight({ position: [0, 3, 0], radius: 0.1, power: [1, 1, 1] }),
          pointLight({ position: [0, 3, 0], power: [1, 1, 1] }),
        ],
        glow,
      ),
    );
    const kinds = unpack(compiled).lights.map(({ kind }) => kind);
    expect(kinds).toHaveLength(3);
    const compared = [...compiled.sceneModule.matchAll(/light\.kind == (\d)u/g)].map(([, kind]) => Number(kind));
    expect(compared).toEqual([...kinds].sort().slice(0, -1)); // the last one needs no comparison
  });

  test("a quad is its corner, edges, area and radiance, and names its primitive", () => {
    const dark = sphere({ center: [9, 9, 9], radius: 1, material: "lambert" });
    expect(pack([dark, QUAD], [], { ior: 1, emission: [3, 2, 1] }).lights).toEqual([
      {
        kind: 1,
        position: [0, 0, 0],
        edge1: [2, 0, 0],
        edge2: [0, 4, 0],
        size: 8,
        radiance: [3, 2, 1],
        id: 1,
        normal: [0, 0, 1],
      },
    ]);
  });

  test("a point has an intensity and no primitive", () => {
    const [light] = pack(
      [],
      [pointLight({ position: [1, 2, 3], power: [4, 8, 12].map((x) => x * Math.PI) as never })],
    ).lights;
    expect(light).toMatchObject({ kind: 3, position: [1, 2, 3], size: 0, id: 0xffffffff });
    expect(light).toMatchObject({ radiance: [1, 2, 3] });
  });
});

test("the slots hold the numbers of the intersection functions", () => {
  const slots = pack([BALL, plane({ point: [0, -7, 0], normal: [0, 1, 0], material: "it" })]).slots.flat();
  for (const value of [1, 2, 3, 0.5, -7]) expect(slots).toContain(value);
});
