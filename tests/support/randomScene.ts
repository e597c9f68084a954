// Scenes of all kinds of shapes, lights and materials, of any size that validation accepts.
import type { Light, Material, Scene, SceneObject, Vec3 } from "../../src/scene/schema";
import { createRandom, randomDirection } from "./random";

export type RandomScene = {
  readonly scene: Scene;
  /** Distance of the camera from its target. */
  readonly scale: number;
  /** Powers of ten by which sizes differ from it, both ways, at most. */
  readonly spread: number;
};

// As scene/numbers.ts has them.
const [LEAST, MOST] = [1e-18, 1e18];

/** A scene from 10⁻¹⁷ to 10¹⁷ across; of every third, sizes differ by up to thirty powers of ten. */
export function randomScene(seed: number): RandomScene {
  const random = createRandom(seed);
  const scale = 10 ** (34 * random() - 17);
  const spread = seed % 3 === 0 ? 30 * random() : 0.5;
  const coordinate = (x: number) => Math.min(Math.max(x, -MOST), MOST);
  const size = () => Math.min(Math.max(scale * 10 ** (spread * (2 * random() - 1) - 0.3), LEAST), MOST);
  const vector = (length: number): Vec3 =>
    randomDirection(random).map((x) => coordinate(length * x)) as unknown as Vec3;
  const edge = () => vector(Math.max(size(), 2 * LEAST));
  const point = () => vector(scale * random());
  const color = (most: number): Vec3 => [most * random(), most * random(), most * random()];
  const pick = <T>(values: readonly T[]): T => values[Math.floor(values.length * random())]!;
  const materials: Record<string, Material> = Object.fromEntries(
    [0, 1, 2, 3, 4].map((k): [string, Material] => [
      `m${k}`,
      {
        baseColor: color(1),
        metallic: pick([0, 0, 1, random()]),
        roughness: pick([0, 1, random(), 1e-3]),
        ior: pick([1, 1.5, 3]),
        ...pick([{ masking: "schlick-beckmann" } as const, { multiscatter: true }, {}, {}]),
        ...(random() < 0.3 && { emission: color(pick([1, 20])) }),
      },
    ]),
  );
  const object = (): SceneObject => {
    const material = `m${Math.floor(5 * random())}`;
    switch (pick(["sphere", "plane", "quad", "flat quad", "triangle", "box", "mesh"] as const)) {
      case "sphere":
        return { type: "sphere", center: point(), radius: size(), material };
      case "plane":
        return { type: "plane", point: point(), normal: randomDirection(random), material };
      case "quad":
        return { type: "quad", corner: point(), edge1: edge(), edge2: edge(), material };
      case "flat quad":
        return { type: "quad", corner: point(), edge1: [size(), 0, 0], edge2: [0, 0, size()], material };
      case "triangle":
        return { type: "triangle", vertices: [point(), vector(size()), vector(size())], material };
      case "box":
        return { type: "box", center: point(), size: [size(), size(), size()], rotationY: pick([0, 33]), material };
      case "mesh": {
        const positions = Array.from({ length: 5 }, () => vector(size())).flat();
        const indices = [0, 1, 2, 0, 2, 3, 1, 3, 4];
        const normals = Array.from({ length: 5 }, () => randomDirection(random)).flat();
        return { type: "mesh", positions, indices, ...(random() < 0.5 && { normals }), material };
      }
    }
  };
  const light = (): Light => {
    const power = color(100);
    return random() < 0.5
      ? { type: "point", position: point(), power }
      : { type: "sphere", position: point(), radius: size(), power };
  };
  const objects = Array.from({ length: pick([2, 8, 40]) }, object);
  const lights = Array.from({ length: pick([0, 1, 3]) }, light);
  const scene: Scene = {
    camera: { position: vector(scale), target: [0, 0, 0], verticalFov: 45 },
    materials,
    objects,
    lights,
    environment: { radiance: pick([color(1), [0, 0, 0]]) },
    maxBounces: 6,
  };
  return { scene, scale, spread };
}
