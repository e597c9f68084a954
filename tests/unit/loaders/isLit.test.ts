import { describe, expect, test } from "vitest";
import { Bounds } from "../../../src/loaders/bounds";
import { frameBounds } from "../../../src/loaders/frameModel";
import { isLit } from "../../../src/loaders/isLit";
import { pointLight } from "../../../src/scene/builders";
import type { Light, Material, Scene, TextureReference, Vec3 } from "../../../src/scene/schema";
import { type MeshData, placed, smoothSphere } from "../../support/meshes";

const GREY: Material = { baseColor: [0.6, 0.6, 0.6] };

type Part = {
  readonly data: MeshData;
  readonly material: Material;
  readonly uvs?: readonly number[];
  readonly uvs1?: readonly number[];
};

/** A scene as the loader makes it, framed by a camera from the front right. */
function sceneOf(parts: readonly Part[], lights: readonly Light[] = [], more: Partial<Scene> = {}): Scene {
  const bounds = new Bounds();
  const objects = parts.map(({ data, uvs, uvs1 }, i) => {
    const positions = Float32Array.from(data.positions);
    const indices = Uint32Array.from(data.indices);
    bounds.add(positions, indices);
    return {
      type: "mesh" as const,
      positions,
      indices,
      material: `${i}`,
      ...(uvs && { uvs: Float32Array.from(uvs) }),
      ...(uvs1 && { uvs1: Float32Array.from(uvs1) }),
    };
  });
  const materials = Object.fromEntries(parts.map(({ material }, i) => [`${i}`, material]));
  return { camera: frameBounds(bounds), objects, materials, lights, ...more };
}

const BALL: Part = { data: smoothSphere(2000), material: GREY };
const glowing = (data: MeshData, ...emission: [number, number, number]): Part => ({
  data,
  material: { baseColor: [0, 0, 0], emission },
});
const bothSides = ({ material, ...part }: Part): Part => ({ ...part, material: { ...material, doubleSided: true } });
/** A square of this side, level, at a height above the ball's middle; its front looks down. */
const panel = (side: number, height: number): MeshData => ({
  positions: [-1, -1, 1, -1, 1, 1, -1, 1].flatMap((x, i, all) =>
    i % 2 === 0 ? [(x * side) / 2, height, (all[i + 1]! * side) / 2] : [],
  ),
  indices: [0, 1, 2, 0, 2, 3],
});
const led = () => placed(smoothSphere(300), 0.04, [0.3, 0.5, 0.95]);

const lit = (parts: readonly Part[], lights?: readonly Light[]) => isLit(sceneOf(parts, lights));
const lamp = (candela: number, position: Vec3) =>
  pointLight({ position, power: [1, 1, 1].map((c) => c * 4 * Math.PI * candela) as unknown as Vec3 });

describe("emitters", () => {
  // 4 cm of radius and a radiance of 1 are 5 mcd: enough up to 20 cm from it. With 1000 it lights all that it can be seen from.
  test("a light-emitting diode on a ball is not enough to see the ball by, a small lamp is", () => {
    expect(lit([BALL, glowing(led(), 1, 0, 0)])).toBe(false);
    expect(lit([BALL, glowing(led(), 10, 10, 10)])).toBe(false);
    expect(lit([BALL, glowing(led(), 1000, 1000, 1000)])).toBe(true);
  });

  // At the ball's top, 2 m below: 16/4 W·m⁻² of a radiance of 1, a 16th of that with a 16th of the area.
  test("a lamp panel above is, if its front looks down and it is not too dim", () => {
    const up = (data: MeshData) => ({ ...data, indices: [0, 2, 1, 0, 3, 2] });
    expect(lit([BALL, glowing(panel(4, 3), 1, 1, 1)])).toBe(true);
    expect(lit([BALL, glowing(panel(4, 3), 0.01, 0.01, 0.01)])).toBe(false);
    expect(lit([BALL, glowing(up(panel(1, 3)), 50, 50, 50)])).toBe(false);
    expect(lit([BALL, bothSides(glowing(up(panel(1, 3)), 50, 50, 50))])).toBe(true);
  });

  // A flame of 1 cm across and 4 cm is seen as π · 1 cm²: with a radiance of 1, 0.31 mcd. At the rim of a plate of 40 cm, 10 cm below
  // and 20 cm aside, that gives 0.31e-3 · 0.1/0.224³ = 2.8e-3 W·m⁻², a fortieth of what is enough.
  test("a candle over a plate is if it is as bright as a flame, and not if it is as dim as a screen", () => {
    const plate: Part = { data: { ...panel(0.4, 0), indices: [0, 2, 1, 0, 3, 2] }, material: GREY };
    const flame = (radiance: number) => {
      const { positions, ...rest } = smoothSphere(300);
      const tall = positions.map((value, i) => (i % 3 === 1 ? 0.1 + 0.02 * value : 0.005 * value));
      return glowing({ ...rest, positions: tall }, radiance, radiance, radiance);
    };
    expect(lit([plate, flame(200)])).toBe(true);
    expect(lit([plate, flame(1)])).toBe(false);
  });

  test("a lamp of one colour is as good as a white one", () => {
    expect(lit([BALL, glowing(panel(4, 3), 0, 0, 1)])).toBe(true);
  });

  test("what glows all over is seen by its own light, unless it glows on its other side only", () => {
    const front: MeshData = { positions: [-1, -1, 0, 1, -1, 0, 0, 1, 0], indices: [0, 1, 2] };
    const back: MeshData = { ...front, indices: [0, 2, 1] };
    expect(lit([glowing(front, 1, 1, 1)])).toBe(true);
    expect(lit([glowing(front, 0.01, 0.01, 0.01)])).toBe(false);
    expect(lit([glowing(back, 1, 1, 1)])).toBe(false);
    expect(lit([bothSides(glowing(back, 1, 1, 1))])).toBe(true);
    expect(lit([{ data: back, material: { unlit: true, baseColor: [0.5, 0.5, 0.5] } }])).toBe(true);
  });

  describe("with a texture", () => {
    const SQUARE: MeshData = { positions: [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], indices: [0, 1, 2, 0, 2, 3] };
    const withTexels = (
      isBright: (column: number) => boolean,
      wrapU: "repeat" | "clamp" | "mirror" = "repeat",
      shift = 0,
      place?: Exclude<TextureReference, string>,
    ) => {
      const texels = Uint8Array.from({ length: 4 * 16 }, (_, i) => (isBright(Math.floor(i / 4)) ? 255 : 0));
      const material: Material = { baseColor: [0, 0, 0], emission: [1, 1, 1], emissionTexture: place ?? "glow" };
      const uvs = [0, 0, 1, 0, 1, 1, 0, 1].map((value, i) => (i % 2 === 0 ? value + shift : value));
      const textures = { glow: { width: 16, height: 1, texels, wrapU } };
      return isLit(sceneOf([{ data: SQUARE, material, uvs }], [], { textures }));
    };

    test("a part that glows leaves the rest dark, and most that does needs no light", () => {
      expect(withTexels((column) => column === 3)).toBe(false);
      expect(withTexels((column) => column !== 3)).toBe(true);
    });

    test("beyond its edges it goes on as its sampler says", () => {
      const isLeft = (column: number) => column < 4;
      expect(withTexels(isLeft, "clamp", -1)).toBe(true);
      expect(withTexels(isLeft, "clamp", 1)).toBe(false);
      expect(withTexels((column) => column < 10, "mirror", 0.75)).toBe(false);
      expect(withTexels((column) => column < 10, "mirror", 1.5)).toBe(true);
    });

    test("in a place of its own it glows there", () => {
      const isLeft = (column: number) => column < 4;
      const glows = (place: object) => withTexels(isLeft, "clamp", 0, { texture: "glow", ...place });
      expect(glows({})).toBe(false);
      expect(glows({ scale: [0.2, 1] })).toBe(true);
      expect(glows({ offset: [-1, 0] })).toBe(true);
      expect(glows({ rotation: 180 })).toBe(true); // u is below 0 then
      expect(glows({ rotation: 90, scale: [1, 0.2] })).toBe(true); // u is a fifth of v
      expect(glows({ rotation: 90, scale: [1, 1] })).toBe(false);
    });

    test("a panel that looks it up with the second set glows where that says", () => {
      const material: Material = { emission: [9, 9, 9], emissionTexture: { texture: "glow", uv: 1 } };
      const lit = (u: number) => {
        const part: Part = { data: panel(4, 3), material, uvs: Array(8).fill(0), uvs1: [u, 0, u, 0, u, 0, u, 0] };
        const texels = Uint8Array.of(0, 0, 0, 255, 255, 255, 255, 255);
        return isLit(sceneOf([BALL, part], [], { textures: { glow: { width: 2, height: 1, texels } } }));
      };
      expect(lit(0.25)).toBe(false);
      expect(lit(0.75)).toBe(true);
    });

    test("a panel whose texture is black gives no light", () => {
      const material: Material = { emission: [9, 9, 9], emissionTexture: "glow" };
      const part: Part = { data: panel(4, 3), material, uvs: [0, 0, 1, 0, 1, 1, 0, 1] };
      const withTexel = (value: number) =>
        isLit(
          sceneOf([BALL, part], [], {
            textures: { glow: { width: 1, height: 1, texels: new Uint8Array(4).fill(value) } },
          }),
        );
      expect(withTexel(0)).toBe(false);
      expect(withTexel(255)).toBe(true);
    });
  });
});

describe("lights", () => {
  // Enough is 3.6/32 = 0.1125 W·m⁻².
  test.each([
    ["dim", 0.1, [1, 1.5, 2], false],
    ["bright", 10, [1, 1.5, 2], true],
    ["far away", 10, [0, 30, 100], false],
    ["far away and very bright", 31_416, [0, 30, 100], true],
    ["behind it", 1000, [-4, -3, -9], false],
    ["to the right of it", 1000, [5, 0, 0], true],
  ] as const)("a lamp that is %s", (_, candela, position, expected) => {
    expect(lit([BALL], [lamp(candela, position)])).toBe(expected);
  });

  test("many dim ones are together enough", () => {
    const lamps = (count: number) => Array.from({ length: count }, () => lamp(0.05, [0.5, 1, 2]));
    expect(lit([BALL], lamps(1))).toBe(false);
    expect(lit([BALL], lamps(30))).toBe(true);
  });

  test("a lamp on a large floor lights what the camera looks at", () => {
    const floor: Part = { data: { ...panel(200, -1), indices: [0, 2, 1, 0, 3, 2] }, material: GREY };
    const scene = sceneOf([BALL, floor], [lamp(20, [1, 2, 2])], { camera: { position: [2, 1.5, 5], verticalFov: 35 } });
    expect(isLit(scene)).toBe(true);
    expect(isLit({ ...scene, camera: { position: [2, 150, 300], target: [0, 0, 0] } })).toBe(false);
  });

  test("without anything in view every light counts", () => {
    const scene = sceneOf([BALL], [lamp(0.1, [1, 1, 2])], { camera: { position: [0, 0, 5], target: [0, 0, 9] } });
    expect(isLit(scene)).toBe(true);
    expect(isLit({ ...scene, lights: [] })).toBe(false);
  });
});
