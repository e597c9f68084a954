import { readdirSync, readFileSync } from "node:fs";
import { describe, expect, expectTypeOf, test } from "vitest";
import { defaultsOf } from "../../../src/scene/containers";
import { parseScene } from "../../../src/scene/parseScene";
import type {
  ResolvedMaterial,
  ResolvedObject,
  ResolvedScene,
  Rgb,
  Scene,
  SceneObject,
  Texture,
  Vec3,
} from "../../../src/scene/schema";
import { MaterialSchema } from "../../../src/scene/schema";

const MINIMAL: Scene = { camera: { position: [0, 1, 5] }, objects: [] };

const SCENES = new URL("../../reference/scenes/", import.meta.url);

describe("defaults", () => {
  test("a camera position and a list of objects are enough", () => {
    expect(parseScene(MINIMAL)).toEqual({
      camera: { position: [0, 1, 5], target: [0, 0, 0], up: [0, 1, 0], verticalFov: 45, aperture: 0 },
      materials: {},
      textures: {},
      objects: [],
      lights: [],
      environment: { radiance: [0, 0, 0] },
      maxBounces: 8,
    });
  });

  test("an empty material is a rough white dielectric", () => {
    expect(parseScene({ ...MINIMAL, materials: { plain: {} } }).materials.plain).toEqual({
      baseColor: [1, 1, 1],
      metallic: 0,
      roughness: 1,
      ior: 1.5,
      emission: [0, 0, 0],
      masking: "smith",
      multiscatter: false,
      alpha: 1,
      alphaMode: "opaque",
      alphaCutoff: 0.5,
      doubleSided: false,
      unlit: false,
      normalScale: 1,
      transmission: 0,
      thickness: 0,
      attenuationColor: [1, 1, 1],
      dispersion: 0,
      diffuseTransmission: 0,
      diffuseTransmissionColor: [1, 1, 1],
      specular: 1,
      specularColor: [1, 1, 1],
      clearcoat: 0,
      clearcoatRoughness: 0,
      clearcoatNormalScale: 1,
      sheenColor: [0, 0, 0],
      sheenRoughness: 0,
      anisotropy: 0,
      anisotropyRotation: 0,
      iridescence: 0,
      iridescenceIor: 1.3,
      iridescenceThickness: 400,
      iridescenceThicknessMinimum: 100,
    });
  });

  test("a box is not rotated", () => {
    const box = { type: "box", center: [0, 0, 0], size: [1, 1, 1], material: "plain" };
    const { objects } = parseScene({ ...MINIMAL, materials: { plain: {} }, objects: [box] });
    expect(objects[0]).toEqual({ ...box, rotationY: 0 });
  });

  test("an empty environment is black", () => {
    expect(parseScene({ ...MINIMAL, environment: {} }).environment.radiance).toEqual([0, 0, 0]);
  });

  test("a mesh without normals has no normals key", () => {
    const mesh = { type: "mesh", positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], indices: [0, 1, 2], material: "plain" };
    const { objects } = parseScene({ ...MINIMAL, materials: { plain: {} }, objects: [mesh] });
    expect(Object.keys(objects[0]!)).toEqual(Object.keys(mesh));
  });

  test("an undefined field counts as absent", () => {
    expect(parseScene({ ...MINIMAL, maxBounces: undefined, lights: undefined }).maxBounces).toBe(8);
  });

  test("two scenes do not share their defaults", () => {
    expect(parseScene(MINIMAL).camera.up).not.toBe(parseScene(MINIMAL).camera.up);
    expect(parseScene(MINIMAL).materials).not.toBe(parseScene(MINIMAL).materials);
  });
});

describe("the reference scenes", () => {
  for (const name of readdirSync(SCENES)) {
    const json = JSON.parse(readFileSync(new URL(name, SCENES), "utf8"));

    test(`${name} parses to what it says`, () => {
      const { $schema, ...scene } = json; // the address of the schema is for editors
      const pictures = Object.entries<Texture>(scene.textures ?? {}).map(([name, texture]) => {
        return [name, { ...texture, texels: Uint8Array.from(texture.texels) }];
      });
      const typed = { objects: scene.objects.map(withTypedArrays), textures: Object.fromEntries(pictures) };
      expect(parseScene(json)).toMatchObject({ ...scene, ...typed });
      expect(parseScene(json)).not.toHaveProperty("$schema");
    });

    test(`${name} parses to the same when it is parsed again`, () => {
      const once = parseScene(json);
      // What is written of a mesh is arrays.
      const hasMesh = once.objects.some(({ type }) => type === "mesh");
      if (!hasMesh) expect(parseScene(once)).toEqual(once);
      const written = JSON.stringify(once, (_, value) =>
        ArrayBuffer.isView(value) ? Array.from(value as never) : value,
      );
      expect(parseScene(JSON.parse(written))).toEqual(once);
    });
  }
});

/** An object as it comes out of the parser. */
function withTypedArrays(object: SceneObject): object {
  if (object.type !== "mesh") return object;
  const { positions, indices, normals, uvs } = object;
  return {
    ...object,
    positions: Float64Array.from(positions),
    indices: Uint32Array.from(indices),
    ...(normals && { normals: Float32Array.from(normals) }),
    ...(uvs && { uvs: Float32Array.from(uvs) }),
  };
}

describe("what is accepted", () => {
  test("$schema is ignored", () => {
    expect(parseScene({ $schema: "./scene.schema.json", ...MINIMAL })).toEqual(parseScene(MINIMAL));
  });

  test("every kind of object and light", () => {
    const material = "m";
    const scene = {
      camera: { position: [0, 0, 5], target: [1, 0, 0], up: [0, 0, 1], verticalFov: 90, aperture: 0 },
      materials: {
        m: {
          ...defaultsOf(MaterialSchema),
          baseColor: [0, 0.5, 1],
          metallic: 1,
          roughness: 0,
          ior: 1,
          emission: [9, 0, 0],
          multiscatter: true,
          normalScale: 2,
        },
      },
      objects: [
        { type: "sphere", center: [1, 2, 3], radius: 0.5, material },
        { type: "plane", point: [0, 0, 0], normal: [0, 2, 0], material },
        { type: "quad", corner: [0, 0, 0], edge1: [1, 0, 0], edge2: [1, 1, 0], material },
        {
          type: "triangle",
          vertices: [
            [0, 0, 0],
            [1, 0, 0],
            [0, 1, 0],
          ],
          material,
        },
        { type: "box", center: [0, 0, 0], size: [1, 2, 3], rotationY: -17, material },
        {
          type: "mesh",
          positions: new Float64Array(3),
          indices: new Uint32Array(3),
          normals: Float32Array.of(0, 1, 0),
          uvs: Float32Array.of(0.5, 0.25),
          uvs1: Float32Array.of(0.25, 0.5),
          material,
        },
      ],
      textures: {
        checks: { width: 1, height: 2, texels: new Uint8Array(8), wrapU: "clamp", wrapV: "mirror", filter: "nearest" },
      },
      lights: [
        { type: "point", position: [0, 4, 0], power: [100, 100, 100] },
        { type: "sphere", position: [0, 4, 0], radius: 0.1, power: [100, 100, 100] },
      ],
      environment: { radiance: [0.1, 0.2, 0.3] },
      maxBounces: 0,
    };
    expect(parseScene(scene)).toEqual(scene);
  });

  test("a reference to a texture, filled in or a name, which can be parsed again", () => {
    const normalTexture = { texture: "t", rotation: 90 };
    const scene = {
      ...MINIMAL,
      textures: { t: { width: 1, height: 1, texels: [0, 0, 0, 0] } },
      materials: { m: { baseColorTexture: "t", normalTexture } },
    };
    const parsed = parseScene(scene);
    expect(parsed.materials.m).toMatchObject({
      baseColorTexture: "t",
      normalTexture: { texture: "t", uv: 0, offset: [0, 0], scale: [1, 1], rotation: 90 },
    });
    expect(parseScene(parsed)).toEqual(parsed);
  });

  test("the numbers of a mesh in plain and in typed arrays", () => {
    const plain = { positions: [0, 0.1, 0, 1, 0, 0, 0, 1, 0], indices: [0, 1, 2], uvs: [0, 0, 1, 0, 0, 1] };
    const parsed = [
      plain,
      {
        positions: Float64Array.from(plain.positions),
        indices: Uint16Array.from(plain.indices),
        uvs: Float32Array.from(plain.uvs),
      },
    ].map((mesh) =>
      parseScene({ ...MINIMAL, materials: { m: {} }, objects: [{ type: "mesh", ...mesh, material: "m" }] }),
    );
    expect(parsed[0]).toEqual(parsed[1]);
    expect(parsed[0]!.objects[0]).toMatchObject({ positions: Float64Array.from(plain.positions) });
  });

  test("a triangle without area", () => {
    const objects = [
      {
        type: "triangle",
        vertices: [
          [0, 0, 0],
          [1, 1, 1],
          [2, 2, 2],
        ],
        material: "m",
      },
    ];
    expect(() => parseScene({ ...MINIMAL, materials: { m: {} }, objects })).not.toThrow();
  });

  test("the largest and the smallest sizes whose squares are f32 numbers", () => {
    const objects = [
      { type: "sphere", center: [1e18, -1e18, 0], radius: 1e18, material: "m" },
      { type: "sphere", center: [0, 0, 0], radius: 1e-18, material: "m" },
    ];
    expect(() => parseScene({ ...MINIMAL, materials: { m: {} }, objects })).not.toThrow();
    const MIN_NORMAL_F32 = 2 ** -126;
    expect(Math.fround(1e-18 ** 2)).toBeGreaterThan(MIN_NORMAL_F32);
    expect(Number.isFinite(Math.fround(3 * 2e18 ** 2))).toBe(true); // |a − b|² of two opposite corners
  });

  test("a class instance with accessors", () => {
    class Rig {
      get position() {
        return [0, 0, 5];
      }
    }
    expect(parseScene({ camera: new Rig(), objects: [] }).camera.position).toEqual([0, 0, 5]);
  });
});

describe("ownership", () => {
  test("changing the input afterwards does not change the scene", () => {
    const position: [number, number, number] = [0, 0, 5];
    const baseColor: [number, number, number] = [0.5, 0.5, 0.5];
    const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0];
    const input = {
      camera: { position },
      materials: { m: { baseColor } },
      objects: [{ type: "mesh", positions, indices: [0, 1, 2], material: "m" }],
    };
    const scene = parseScene(input);
    const before = structuredClone(scene);
    position[0] = baseColor[0] = positions[0] = 0.25;
    input.objects.pop();
    expect(scene).toEqual(before);
  });

  test("a deeply frozen input parses", () => {
    const freeze = (value: object): void => {
      for (const inner of Object.values(value)) if (typeof inner === "object") freeze(inner);
      Object.freeze(value);
    };
    const json = JSON.parse(readFileSync(new URL("spheres.json", SCENES), "utf8"));
    freeze(json);
    expect(() => parseScene(json)).not.toThrow();
  });
});

describe("types", () => {
  test("only what has a default is optional", () => {
    expectTypeOf<{ camera: { position: [number, number, number] }; objects: [] }>().toExtend<Scene>();
    expectTypeOf<{ objects: [] }>().not.toExtend<Scene>();
    expectTypeOf<{ camera: { position: [0, 0, 5] } }>().not.toExtend<Scene>();
    expectTypeOf<ResolvedScene["maxBounces"]>().toEqualTypeOf<number>();
    type Filled = Omit<ResolvedMaterial, `${string}Texture` | "attenuationDistance">;
    expectTypeOf<Filled>().toExtend<Required<Filled>>();
  });

  test("a resolved scene is a scene, and one written as const too", () => {
    expectTypeOf<ResolvedScene>().toExtend<Scene>();
    const scene = {
      camera: { position: [0, 0, 5] },
      materials: { red: { baseColor: [1, 0, 0] } },
      objects: [{ type: "sphere", center: [0, 0, 0], radius: 1, material: "red" }],
    } as const;
    expectTypeOf(scene).toExtend<Scene>();
  });

  test("vectors are triples, and type tells objects apart", () => {
    expectTypeOf<ResolvedScene["camera"]["position"]>().toEqualTypeOf<Vec3>();
    expectTypeOf<ResolvedMaterial["baseColor"]>().toEqualTypeOf<Rgb>();
    expectTypeOf<Extract<ResolvedObject, { type: "box" }>["rotationY"]>().toEqualTypeOf<number>();
    expectTypeOf<ResolvedObject["type"]>().toEqualTypeOf<"sphere" | "plane" | "quad" | "triangle" | "box" | "mesh">();
  });
});
