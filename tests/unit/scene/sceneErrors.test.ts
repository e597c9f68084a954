import { describe, expect, test } from "vitest";
import { SceneError } from "../../../src/errors";
import { parseScene } from "../../../src/scene/parseScene";

const CAMERA = { position: [0, 0, 5] };
const SPHERE = { type: "sphere", center: [0, 0, 0], radius: 1, material: "m" };
const SIZE_HINT = "(its square must fit in f32)";

/** The lines of the error that parsing `input` throws, without the heading. */
function errorsOf(input: unknown): string[] {
  try {
    parseScene(input);
  } catch (error) {
    expect(error).toBeInstanceOf(SceneError);
    return (error as SceneError).message.split("\n").slice(1);
  }
  return [];
}

const withCamera = (fields: object) => errorsOf({ camera: { ...CAMERA, ...fields }, objects: [] });
const withMaterial = (fields: object) => errorsOf({ camera: CAMERA, objects: [], materials: { m: fields } });
const withObject = (object: unknown) => errorsOf({ camera: CAMERA, materials: { m: {} }, objects: [object] });
const withLight = (light: unknown) => errorsOf({ camera: CAMERA, objects: [], lights: [light] });
const withScene = (fields: object) => errorsOf({ camera: CAMERA, objects: [], ...fields });

describe("all issues at once", () => {
  test("every issue is reported, each with its path", () => {
    const lines = errorsOf({
      camera: { position: [0, Number.NaN, 5], verticalFov: 180 },
      materials: { m: { roughness: 2, metallic: "1" } },
      objects: [SPHERE, { ...SPHERE, radius: -1, material: "gold" }, { type: "cube" }],
      lights: [{ type: "point", position: [0, 1], power: [1, 1, -1] }],
      environment: { radiance: 1 },
      maxBounces: 2.5,
      enviroment: {},
    });
    expect(lines).toEqual([
      "camera.position[1]: expected a finite number, got NaN",
      "camera.verticalFov: expected an angle between 0 and 180 degrees, got 180",
      'materials.m.metallic: expected a number from 0 to 1, got "1"',
      "materials.m.roughness: expected a number from 0 to 1, got 2",
      "objects[1].radius: expected a finite number > 0, got -1",
      'objects[2].type: expected "sphere", "plane", "quad", "triangle", "box" or "mesh", got "cube"',
      "lights[0].position: expected [x, y, z], got [0, 1]",
      "lights[0].power[2]: expected a finite number ≥ 0, got -1",
      "environment.radiance: expected [r, g, b], got 1",
      "maxBounces: expected an integer from 0 to 1024, got 2.5",
      'enviroment: unknown key; did you mean "environment"?',
      'objects[1].material: no material is named "gold"; there are "m"',
    ]);
  });

  test("issues are data too", () => {
    try {
      parseScene({ camera: CAMERA, objects: [SPHERE, { ...SPHERE, radius: 0 }], materials: { m: {} } });
      expect.unreachable();
    } catch (error) {
      expect((error as SceneError).message).toBe(
        "The scene has 1 error:\nobjects[1].radius: expected a finite number > 0, got 0",
      );
      expect((error as SceneError).issues).toEqual([
        { path: "objects[1].radius", message: "expected a finite number > 0, got 0" },
      ]);
    }
  });
});

describe("the scene", () => {
  test.each([
    [null, "null"],
    [undefined, "nothing"],
    [[], "[]"],
    ["{}", '"{}"'],
    [7, "7"],
    [() => 1, "a function"],
  ])("%o is not a scene", (input, shown) => {
    expect(errorsOf(input)).toEqual([`scene: expected an object, got ${shown}`]);
  });

  test("camera and objects are required", () => {
    expect(errorsOf({})).toEqual([
      "camera: expected an object, got nothing",
      "objects: expected an array, got nothing",
    ]);
  });

  test("containers are of the right kind", () => {
    expect(withScene({ materials: [], objects: {}, lights: "x", environment: null, $schema: 1 })).toEqual([
      "$schema: expected the address of a JSON schema, got 1",
      "materials: expected an object, got []",
      "objects: expected an array, got {}",
      'lights: expected an array, got "x"',
      "environment: expected an object, got null",
    ]);
  });

  test.each([-1, 1.5, 1025, Number.NaN, Number.POSITIVE_INFINITY, "8", null])("maxBounces is not %o", (maxBounces) => {
    const shown = typeof maxBounces === "string" ? '"8"' : String(maxBounces);
    expect(withScene({ maxBounces })).toEqual([`maxBounces: expected an integer from 0 to 1024, got ${shown}`]);
  });

  test("radiance of the environment is not negative", () => {
    expect(withScene({ environment: { radiance: [0, -0.1, 0] } })).toEqual([
      "environment.radiance[1]: expected a finite number ≥ 0, got -0.1",
    ]);
  });
});

describe("numbers", () => {
  test.each([
    [Number.NaN, "NaN"],
    [Number.POSITIVE_INFINITY, "Infinity"],
    [Number.NEGATIVE_INFINITY, "-Infinity"],
    ["1", '"1"'],
    [null, "null"],
    [true, "true"],
    [[1], "[1]"],
    [1n, "1n"],
    [undefined, "nothing"],
  ])("%o is not a finite number", (x, shown) => {
    expect(withCamera({ position: [x, 0, 5] })).toEqual([`camera.position[0]: expected a finite number, got ${shown}`]);
  });

  test("squares must fit in f32", () => {
    expect(withCamera({ position: [0, 0, 1e30] })).toEqual([
      `camera.position[2]: expected a magnitude of at most 1000000000000000000 ${SIZE_HINT}, got 1e+30`,
    ]);
    expect(withObject({ ...SPHERE, radius: 1e-30 })).toEqual([
      `objects[0].radius: expected a number of at least 1e-18 ${SIZE_HINT}, got 1e-30`,
    ]);
  });

  test.each([
    [[1, 2], "[1, 2]"],
    [[1, 2, 3, 4], "[1, 2, 3, 4]"],
    [{ x: 1, y: 2, z: 3 }, '{"x": 1, "y": 2, "z": 3}'],
    [new Float32Array(3), "a Float32Array"],
    ["0 0 0", '"0 0 0"'],
    [undefined, "nothing"],
  ])("%o is not a vector", (position, shown) => {
    expect(withCamera({ position })).toEqual([`camera.position: expected [x, y, z], got ${shown}`]);
  });

  test("long values are cut", () => {
    const [line] = withCamera({ position: Array.from({ length: 1000 }, (_, i) => i) });
    expect(line).toBe("camera.position: expected [x, y, z], got [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, …");
  });
});

describe("camera", () => {
  test("the lens has a radius ≥ 0, and its focus is before it", () => {
    for (const aperture of [-1e-9, -1, Number.NaN, Number.POSITIVE_INFINITY]) {
      expect(withCamera({ aperture })).toEqual([`camera.aperture: expected a finite number ≥ 0, got ${aperture}`]);
    }
    for (const focusDistance of [0, -1, Number.NaN, Number.POSITIVE_INFINITY]) {
      const message = `camera.focusDistance: expected a finite number > 0, got ${focusDistance}`;
      expect(withCamera({ focusDistance })).toEqual([message]);
    }
    expect(withCamera({ aperture: 0, focusDistance: 1e-6 })).toEqual([]);
  });

  test.each([0, -3, Number.NaN, Number.POSITIVE_INFINITY, "3"])(
    "orthographicHeight is positive: %s",
    (orthographicHeight) => {
      const shown = typeof orthographicHeight === "string" ? '"3"' : orthographicHeight;
      const message = `camera.orthographicHeight: expected a finite number > 0, got ${shown}`;
      expect(withCamera({ orthographicHeight })).toEqual([message]);
    },
  );

  test("the angle of view is between 0 and 180 degrees", () => {
    for (const verticalFov of [0, 180, -45]) {
      const message = `camera.verticalFov: expected an angle between 0 and 180 degrees, got ${verticalFov}`;
      expect(withCamera({ verticalFov })).toEqual([message]);
    }
  });

  test("it looks somewhere else than where it is", () => {
    expect(withCamera({ target: [0, 0, 5] })).toEqual([
      "camera.target: expected a point other than position, got [0, 0, 5]",
    ]);
    expect(withCamera({ position: [0, 0, 0] })).toEqual([
      "camera.target: expected a point other than position, got [0, 0, 0]",
    ]);
  });

  test("up is not the direction of view", () => {
    const message = "camera.up: expected a direction that is not parallel to the view, got";
    expect(withCamera({ up: [0, 0, -3] })).toEqual([`${message} [0, 0, -3]`]);
    expect(withCamera({ position: [0, 5, 0] })).toEqual([`${message} [0, 1, 0]`]);
    expect(withCamera({ up: [0, 0, 0] })).toEqual(["camera.up: expected a vector that is not zero, got [0, 0, 0]"]);
  });

  test("up and target are judged although the angle is wrong", () => {
    expect(withCamera({ verticalFov: 0, up: [0, 0, 1] })).toHaveLength(2);
  });
});

describe("materials", () => {
  test.each([
    [{ baseColor: [0, 1.01, 0] }, "baseColor[1]: expected a number from 0 to 1, got 1.01"],
    [{ baseColor: "#f00" }, 'baseColor: expected [r, g, b], got "#f00"'],
    [{ metallic: -0.1 }, "metallic: expected a number from 0 to 1, got -0.1"],
    [{ metallic: true }, "metallic: expected a number from 0 to 1, got true"],
    [{ roughness: 1.5 }, "roughness: expected a number from 0 to 1, got 1.5"],
    [{ ior: 0 }, "ior: expected a finite number > 0, got 0"],
    [{ emission: [-1, 0, 0] }, "emission[0]: expected a finite number ≥ 0, got -1"],
    [{ masking: "ggx" }, 'masking: expected "smith" or "schlick-beckmann", got "ggx"'],
    [{ masking: "Smith" }, 'masking: expected "smith" or "schlick-beckmann", got "Smith"; did you mean "smith"?'],
    [{ multiscatter: 1 }, "multiscatter: expected true or false, got 1"],
    [
      { multiscatter: true, masking: "schlick-beckmann" },
      'multiscatter: expected false with masking "schlick-beckmann", got true; use masking "smith"',
    ],
  ])("%o is refused", (fields, message) => {
    expect(withMaterial(fields)).toEqual([`materials.m.${message}`]);
  });

  test("a material is an object", () => {
    expect(withScene({ materials: { red: "red", blue: null } })).toEqual([
      'materials.red: expected an object, got "red"',
      "materials.blue: expected an object, got null",
    ]);
  });

  test("a name that is not an identifier is quoted in the path", () => {
    expect(withScene({ materials: { "old gold": { ior: 0 }, größe: { ior: 0 }, "1": { ior: 0 } } })).toEqual([
      'materials["1"].ior: expected a finite number > 0, got 0',
      'materials["old gold"].ior: expected a finite number > 0, got 0',
      "materials.größe.ior: expected a finite number > 0, got 0",
    ]);
  });
});

describe("names of materials", () => {
  test("an unknown name is refused, and the names that exist are listed", () => {
    const scene = { camera: CAMERA, materials: { red: {}, floor: {} }, objects: [{ ...SPHERE, material: "gold" }] };
    expect(errorsOf(scene)).toEqual(['objects[0].material: no material is named "gold"; there are "red", "floor"']);
  });

  test("without materials no name is known", () => {
    const message = 'objects[0].material: no material is named "m"; the scene has no materials';
    expect(withScene({ objects: [SPHERE] })).toEqual([message]);
  });

  test("of many names the first eight are listed", () => {
    const materials = Object.fromEntries(Array.from({ length: 10 }, (_, i) => [`m${i}`, {}]));
    expect(withScene({ materials, objects: [SPHERE] })).toEqual([
      'objects[0].material: no material is named "m"; there are "m0", "m1", "m2", "m3", "m4", "m5", "m6", "m7", 2 more',
    ]);
  });

  test("a faulty material still counts as named", () => {
    expect(withScene({ materials: { m: { ior: 0 } }, objects: [SPHERE] })).toEqual([
      "materials.m.ior: expected a finite number > 0, got 0",
    ]);
  });

  test("the name is required and a string", () => {
    const message = "objects[0].material: expected the name of a material, got";
    expect(withObject({ ...SPHERE, material: undefined })).toEqual([`${message} nothing`]);
    expect(withObject({ ...SPHERE, material: { ior: 1 } })).toEqual([`${message} {"ior": 1}`]);
  });
});

describe("objects", () => {
  const quad = { type: "quad", corner: [0, 0, 0], edge1: [1, 0, 0], edge2: [0, 1, 0], material: "m" };
  const plane = { type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material: "m" };
  const box = { type: "box", center: [0, 0, 0], size: [1, 1, 1], material: "m" };
  const triangle = { type: "triangle", material: "m" };

  test.each([
    [3, "objects[0]: expected an object, got 3"],
    [{}, 'objects[0].type: expected "sphere", "plane", "quad", "triangle", "box" or "mesh", got nothing'],
    [
      { type: "shpere" },
      'objects[0].type: expected "sphere", "plane", "quad", "triangle", "box" or "mesh", got "shpere"; did you mean "sphere"?',
    ],
    [{ ...SPHERE, radius: 0 }, "objects[0].radius: expected a finite number > 0, got 0"],
    [{ ...SPHERE, radius: Number.NaN }, "objects[0].radius: expected a finite number > 0, got NaN"],
    [{ ...SPHERE, center: undefined }, "objects[0].center: expected [x, y, z], got nothing"],
    [{ ...plane, normal: [0, 0, 0] }, "objects[0].normal: expected a vector that is not zero, got [0, 0, 0]"],
    [{ ...quad, edge1: [0, 0, 0] }, "objects[0].edge1: expected a vector that is not zero, got [0, 0, 0]"],
    [
      { ...quad, edge2: [-2, 0, 0] },
      "objects[0].edge2: expected a direction that is not parallel to edge1, got [-2, 0, 0]",
    ],
    [
      { ...quad, edge2: [1e9, 1, 0] },
      "objects[0].edge2: expected a direction that is not parallel to edge1, got [1000000000, 1, 0]",
    ],
    [{ ...box, size: [1, 0, 1] }, "objects[0].size[1]: expected a finite number > 0, got 0"],
    [{ ...box, rotationY: "18" }, 'objects[0].rotationY: expected a finite number, got "18"'],
    [{ ...triangle, vertices: [[0, 0, 0]] }, "objects[0].vertices: expected [a, b, c], got [[…]]"],
    [
      {
        ...triangle,
        vertices: [
          [0, 0, 0],
          [0, 0],
          [0, 1, null],
        ],
      },
      "objects[0].vertices[1]: expected [x, y, z], got [0, 0]",
      "objects[0].vertices[2][2]: expected a finite number, got null",
    ],
  ])("%o is refused", (object, ...messages) => {
    expect(withObject(object)).toEqual(messages);
  });

  test("a mesh whose lists do not fit together is refused", () => {
    const mesh = { type: "mesh", positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], indices: [0, 1, 2], material: "m" };
    expect(withObject({ ...mesh, positions: [0, 0, 0, 1] })).toEqual([
      "objects[0].positions: expected three numbers per vertex, got 4 numbers",
      "objects[0].indices[1]: expected an index of one of the 1 vertices, got 1",
    ]);
    expect(withObject({ ...mesh, indices: [0, 1] })).toEqual([
      "objects[0].indices: expected three indices per triangle, got 2 indices",
    ]);
    expect(withObject({ ...mesh, indices: [0, 1, 3] })).toEqual([
      "objects[0].indices[2]: expected an index of one of the 3 vertices, got 3",
    ]);
    expect(withObject({ ...mesh, indices: [0, -1, 0.5] })).toEqual([
      "objects[0].indices[1]: expected an integer from 0 to 4294967294, got -1",
      "objects[0].indices[2]: expected an integer from 0 to 4294967294, got 0.5",
    ]);
    expect(withObject({ ...mesh, indices: { 0: 0, length: 1 } })).toEqual([
      'objects[0].indices: expected an array, got {"0": 0, "length": 1}',
    ]);
    expect(withObject({ ...mesh, normals: [0, 0, 1] })).toEqual([
      "objects[0].normals: expected as many numbers as positions (9), got 3",
    ]);
    expect(withObject({ ...mesh, uvs: new Float32Array(4) })).toEqual([
      "objects[0].uvs: expected two numbers per vertex (6), got 4",
    ]);
    expect(withObject({ ...mesh, positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, Number.NaN, 0) })).toEqual([
      "objects[0].positions[7]: expected a finite number, got NaN",
    ]);
  });
});

const SPOT = { type: "spot", position: [0, 1, 0], direction: [0, -1, 0] } as const;

describe("lights", () => {
  test.each([
    [{ type: "lamp" }, 'lights[0].type: expected "point", "sphere", "spot" or "directional", got "lamp"'],
    [{ ...SPOT }, "lights[0].power: expected this or intensity, got neither"],
    [{ ...SPOT, power: [1, 1, 1], intensity: [1, 1, 1] }, "lights[0].intensity: expected this or power, got both"],
    [
      { ...SPOT, power: [1, 1, 1], innerAngle: 45 },
      "lights[0].innerAngle: expected an angle less than outerAngle (45), got 45",
    ],
    [
      { ...SPOT, power: [1, 1, 1], outerAngle: 91 },
      "lights[0].outerAngle: expected an angle from 0.001 to 90 degrees, got 91",
    ],
    [{ ...SPOT, power: [1, 1, 1], radius: -1 }, "lights[0].radius: expected a finite number ≥ 0, got -1"],
    [
      { type: "directional", direction: [0, 0, 0], irradiance: [1, 1, 1] },
      "lights[0].direction: expected a vector that is not zero, got [0, 0, 0]",
    ],
    [
      { type: "directional", direction: [0, -1, 0], irradiance: [1, 1, 1], angularDiameter: 180 },
      "lights[0].angularDiameter: expected an angle from 0 to less than 180 degrees, got 180",
    ],
    [{ type: "directional", direction: [0, -1, 0] }, "lights[0].irradiance: expected [r, g, b], got nothing"],
    [{ type: "point", position: [0, 1, 0] }, "lights[0].power: expected [r, g, b], got nothing"],
    [{ type: "point", position: [0, 1, 0], power: 60 }, "lights[0].power: expected [r, g, b], got 60"],
    [
      { type: "sphere", position: [0, 1, 0], radius: 0, power: [1, 1, 1] },
      "lights[0].radius: expected a finite number > 0, got 0",
    ],
    [
      { type: "point", position: [0, 1, 0], radius: 1, power: [1, 1, 1] },
      'lights[0].radius: unknown key; the keys here are "type", "position", "power"',
    ],
  ])("%o is refused", (light, message) => {
    expect(withLight(light)).toEqual([message]);
  });
});

describe("unknown keys", () => {
  test.each([
    ["rougness", "roughness"],
    ["Roughness", "roughness"],
    ["basecolor", "baseColor"],
    ["base_color", "baseColor"],
    ["emision", "emission"],
    ["metalic", "metallic"],
  ])("%s is taken for %s", (key, meant) => {
    expect(withMaterial({ [key]: 0.5 })).toEqual([`materials.m.${key}: unknown key; did you mean "${meant}"?`]);
  });

  test("where nothing is close, the known keys are listed", () => {
    expect(withCamera({ fov: 45 })).toEqual([
      'camera.fov: unknown key; the keys here are "position", "target", "up", "verticalFov", "orthographicHeight", "aperture", "focusDistance"',
    ]);
  });

  test("all of them are reported", () => {
    expect(withMaterial({ a: 1, b: 2, rougness: 3 })).toHaveLength(3);
  });
});

describe("textures", () => {
  const texture = { width: 1, height: 2, texels: [0, 0, 0, 255, 9, 9, 9, 255] };
  const uvMesh = { type: "mesh", positions: [0, 0, 0], indices: [0, 0, 0], uvs: [0, 0], material: "m" };
  const withTexture = (changes: object, material: object = {}, object: object = uvMesh) =>
    errorsOf({
      camera: CAMERA,
      textures: { t: { ...texture, ...changes } },
      materials: { m: material },
      objects: [object],
    });

  test.each([
    [{ width: 0 }, "textures.t.width: expected an integer from 1 to 16384, got 0"],
    [{ texels: [1, 2, 3] }, "textures.t.texels: expected 8 numbers, four per texel, got 3"],
    [{ texels: [0, 0, 0, 256, 0, 0, 0, 0] }, "textures.t.texels[3]: expected an integer from 0 to 255, got 256"],
    [{ wrapU: "wrap" }, 'textures.t.wrapU: expected "repeat", "mirror" or "clamp", got "wrap"'],
    [{ filter: "cubic" }, 'textures.t.filter: expected "linear" or "nearest", got "cubic"'],
  ])("%o is refused", (changes, message) => {
    expect(withTexture(changes)).toEqual([message]);
  });

  test("a material that names one that is not there is refused", () => {
    expect(withTexture({}, { baseColorTexture: "u" })).toEqual([
      'materials.m.baseColorTexture: no texture is named "u"; there are "t"',
    ]);
  });

  test.each<[reference: unknown, messages: string[]]>([
    [7, ["expected the name of a texture or an object with one, got 7"]],
    [["t"], ['expected the name of a texture or an object with one, got ["t"]']],
    [{}, [".texture: expected the name of a texture, got nothing"]],
    [{ texture: "u" }, ['.texture: no texture is named "u"; there are "t"']],
    [{ texture: "t", uv: 2 }, [".uv: expected 0 or 1, got 2"]],
    [{ texture: "t", offset: [1] }, [".offset: expected [u, v], got [1]"]],
    [{ texture: "t", scale: 2 }, [".scale: expected [u, v], got 2"]],
    [{ texture: "t", rotation: "90" }, ['.rotation: expected a finite number, got "90"']],
    [{ texture: "t", ofset: [0, 1] }, ['.ofset: unknown key; did you mean "offset"?']],
    [
      { texture: 1, uv: "0", offset: [0, null] },
      [
        ".texture: expected the name of a texture, got 1",
        '.uv: expected 0 or 1, got "0"',
        ".offset[1]: expected a finite number, got null",
      ],
    ],
  ])("a reference %o is refused with its path", (reference, messages) => {
    const at = (message: string) => `materials.m.normalTexture${message.startsWith(".") ? "" : ": "}${message}`;
    expect(withTexture({}, { normalTexture: reference })).toEqual(messages.map(at));
  });

  test("a texture with uv 1 is for meshes with uvs1", () => {
    const second = { normalTexture: { texture: "t", uv: 1 } };
    const message = 'objects[0].material: "m" has normalTexture with uv 1, which shows on meshes with uvs1 only';
    expect(withTexture({}, second)).toEqual([message]);
    expect(withTexture({}, { ...second, metallicRoughnessTexture: "t" })).toEqual([message]);
    const { uvs, ...plain } = uvMesh;
    expect(withTexture({}, second, { ...plain, uvs1: uvs })).toEqual([]);
    expect(withTexture({}, { ...second, baseColorTexture: "t" }, { ...uvMesh, uvs1: uvs })).toEqual([]);
    expect(withTexture({}, second, { ...uvMesh, uvs1: [0] })).toEqual([
      "objects[0].uvs1: expected two numbers per vertex (2), got 1",
    ]);
  });

  test("a textured material is for meshes with uvs", () => {
    const { uvs, ...plain } = uvMesh;
    const message = 'objects[0].material: "m" has textures, which show on meshes with uvs only';
    expect(withTexture({}, { baseColorTexture: "t" }, plain)).toEqual([message]);
    expect(
      withTexture({}, { baseColorTexture: "t" }, { type: "sphere", center: [0, 0, 0], radius: 1, material: "m" }),
    ).toEqual([message]);
    expect(withTexture({}, { baseColorTexture: "t", normalTexture: "t" })).toEqual([]);
  });
});
