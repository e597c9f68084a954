import { describe, expect, test } from "vitest";
import { SceneError } from "../../../src/errors";
import { parseCamera, parseScene } from "../../../src/scene/parseScene";

const CAMERA = { position: [0, 0, 5] };

/** What is wrong with a scene, if anything is. */
function errorOf(input: unknown): SceneError | undefined {
  try {
    parseScene(input);
  } catch (error) {
    if (error instanceof SceneError) return error;
    throw error;
  }
  return undefined;
}

const issuesOf = (input: unknown): SceneError["issues"] => errorOf(input)?.issues ?? [];

describe("names that objects inherit", () => {
  const names = ["__proto__", "constructor", "prototype", "toString", "hasOwnProperty", ""];

  test.each(names)("%o is a name like any other", (name) => {
    // JSON.parse makes "__proto__" an ordinary key, as a scene file would.
    const json = JSON.stringify({ camera: CAMERA, objects: [{ type: "sphere", center: [0, 0, 0], radius: 1 }] });
    const input = JSON.parse(json);
    input.objects[0].material = name;
    input.materials = JSON.parse(`{${JSON.stringify(name)}: {"roughness": 0.25}}`);
    const { materials, objects } = parseScene(input);
    expect(Object.keys(materials)).toEqual([name]);
    expect(materials[objects[0]!.material]?.roughness).toBe(0.25);
  });

  test.each(names)("%o is no material where none has that name", (material) => {
    const objects = [{ type: "sphere", center: [0, 0, 0], radius: 1, material }];
    expect(issuesOf({ camera: CAMERA, materials: { red: {} }, objects })).toEqual([
      { path: "objects[0].material", message: `no material is named ${JSON.stringify(material)}; there are "red"` },
    ]);
    expect(parseScene({ camera: CAMERA, objects: [] }).materials[material]).toBeUndefined();
  });

  test.each(names)("%o is no type of object", (type) => {
    expect(issuesOf({ camera: CAMERA, objects: [{ type }] })[0]?.path).toBe("objects[0].type");
  });

  test("they are unknown keys elsewhere", () => {
    const camera = JSON.parse('{"position": [0, 0, 5], "__proto__": {"up": [1, 0, 0]}, "constructor": 1}');
    const paths = issuesOf({ camera, objects: [] }).map(({ path }) => path);
    expect(paths).toEqual(["camera.__proto__", "camera.constructor"]);
  });

  test("nothing reaches Object.prototype", () => {
    issuesOf(JSON.parse('{"__proto__": {"polluted": 1}, "materials": {"__proto__": {"polluted": 1}}}'));
    parseScene({ camera: CAMERA, objects: [], materials: JSON.parse('{"__proto__": {}}') });
    expect(Reflect.has({}, "polluted")).toBe(false);
    expect(Reflect.has({}, "baseColor")).toBe(false);
  });
});

describe("input that is not plain data", () => {
  test("a cycle is an issue", () => {
    const camera: Record<string, unknown> = { position: [0, 0, 5] };
    camera.target = camera;
    const loop: unknown[] = [];
    loop.push(loop);
    expect(issuesOf({ camera, objects: loop })).toEqual([
      { path: "camera.target", message: 'expected [x, y, z], got {"position": […], "target": {…}}' },
      { path: "objects[0]", message: "expected an object, got [[…]]" },
    ]);
  });

  test("a getter that throws is an issue, and its error the cause", () => {
    const cause = new Error("gone");
    const input = {
      objects: [],
      get camera() {
        throw cause;
      },
    };
    expect(() => parseScene(input)).toThrow(
      expect.objectContaining({
        name: "SceneError",
        message: "The scene has 1 error:\nscene: expected plain data; reading it threw the error in `cause`",
        cause,
      }),
    );
  });

  test("a getter that calls itself for ever is an issue", () => {
    const input = {
      objects: [],
      get camera(): unknown {
        return this.camera;
      },
    };
    expect(issuesOf(input)).toHaveLength(1);
  });

  test("a revoked proxy is an issue", () => {
    const { proxy, revoke } = Proxy.revocable({}, {});
    revoke();
    expect(issuesOf(proxy)).toHaveLength(1);
    expect(issuesOf({ camera: CAMERA, objects: [proxy] })).toHaveLength(1);
  });

  test.each([new Map(), new Date(), new Set(), /x/, Symbol("s"), 1n, Object.create(null)])(
    "%o is not a scene",
    (input) => {
      expect(issuesOf(input).length).toBeGreaterThan(0);
    },
  );

  test("a position that changes while it is read is read once", () => {
    let reads = 0;
    const position = [0, 0, 5];
    Object.defineProperty(position, 0, { get: () => (reads++ === 0 ? 1 : Number.NaN), enumerable: true });
    expect(parseScene({ camera: { position }, objects: [] }).camera.position).toEqual([1, 0, 5]);
  });
});

describe("input that answers differently each time", () => {
  /** The input, and every read of a property in it: `objects[0].type`. */
  function watched(input: object, change?: (read: number, value: unknown) => unknown): [object, string[]] {
    const reads: string[] = [];
    const wrap = (value: unknown, path: string): unknown => {
      if (typeof value !== "object" || value === null || ArrayBuffer.isView(value)) return value;
      return new Proxy(value, {
        get(target, key) {
          const at = typeof key === "symbol" ? `${path}[symbol]` : `${path}.${key}`;
          const count = reads.filter((read) => read === at).length;
          reads.push(at);
          const found = wrap(Reflect.get(target, key), at);
          return change === undefined ? found : change(count, found);
        },
        getOwnPropertyDescriptor(target, key) {
          return Reflect.getOwnPropertyDescriptor(target, key);
        },
      });
    };
    return [wrap(input, "") as object, reads];
  }

  const everything = {
    camera: { position: [0, 1, 5], target: [0, 0, 0], up: [0, 1, 0], verticalFov: 40 },
    materials: { m: { baseColor: [1, 0, 0], roughness: 0.5, masking: "smith", baseColorTexture: "t" }, n: {} },
    textures: { t: { width: 1, height: 2, texels: [1, 2, 3, 4, 5, 6, 7, 8], wrapU: "clamp" } },
    objects: [
      { type: "sphere", center: [0, 0, 0], radius: 1, material: "n" },
      { type: "triangle", vertices: Array(3).fill([0, 0, 0]), material: "n" },
      {
        type: "mesh",
        positions: [0, 0, 0, 1, 0, 0, 0, 1, 0],
        indices: [0, 1, 2],
        uvs: Array(6).fill(0),
        material: "m",
      },
    ],
    lights: [{ type: "point", position: [0, 3, 0], power: [1, 1, 1] }],
    environment: { radiance: [1, 1, 1] },
    maxBounces: 3,
  };

  test("each property is read once", () => {
    const [input, reads] = watched(everything);
    expect(parseScene(input)).toEqual(parseScene(everything));
    expect(reads.filter((read, i) => reads.indexOf(read) < i)).toEqual([]);
    expect(reads).toContain(".objects.0.type");
    expect(reads).toContain(".objects.2.indices.length");
    const readCount = reads.length;
    parseCamera(watched(everything.camera)[0]);
    expect(reads).toHaveLength(readCount); // nothing was left to be read later
  });

  test("each property of a faulty scene is read once too, but to show what is wrong", () => {
    const [input, reads] = watched({
      ...everything,
      objects: [{ ...everything.objects[0], radius: -1, material: "x" }],
    });
    expect(issuesOf(input).map(({ path }) => path)).toEqual(["objects[0].radius", "objects[0].material"]);
    expect(reads.filter((read, i) => reads.indexOf(read) < i)).toEqual([]);
  });

  test("what is sound at the first read and not at the second is taken as it was", () => {
    const bad = (read: number, value: unknown) => (read === 0 ? value : { type: "plane", length: 4e9 });
    expect(parseScene(watched(everything, bad)[0])).toEqual(parseScene(everything));
  });

  test("a camera's properties are read once", () => {
    const [input, reads] = watched(everything.camera);
    expect(parseCamera(input)).toEqual(parseScene(everything).camera);
    expect(reads).toHaveLength(new Set(reads).size);
  });

  test("an array whose length is made up is refused, or as long as it says", () => {
    for (const length of [Number.NaN, -1, 0.5, 1e300, "2", null, {}]) {
      const objects = new Proxy([], { get: (_, key) => (key === "length" ? length : undefined) });
      const [issue, ...rest] = issuesOf({ camera: CAMERA, objects });
      expect(issue?.message).toMatch(/^expected at most 1048576 entries, got /);
      expect(rest).toEqual([]);
    }
  });

  test("a typed array that pretends to be another is read as what it is", () => {
    const indices = new Float32Array([0, -1, 0.5]);
    Object.setPrototypeOf(indices, Uint8Array.prototype);
    const objects = [{ type: "mesh", positions: [0, 0, 0], indices, material: "m" }];
    const paths = issuesOf({ camera: CAMERA, materials: { m: {} }, objects }).map(({ path }) => path);
    expect(paths).toEqual(["objects[0].indices[1]", "objects[0].indices[2]"]);
  });

  test("a typed array that overrides its length and its copies is no way in", () => {
    class Liar extends Uint8Array {
      static get [Symbol.species]() {
        return Float32Array as unknown as Uint8ArrayConstructor;
      }
      override get length() {
        return 4;
      }
      override slice(): never {
        throw new Error("called");
      }
      override [Symbol.iterator](): never {
        throw new Error("called");
      }
    }
    const texture = { width: 1, height: 1, texels: new Liar(8) };
    expect(issuesOf({ camera: CAMERA, objects: [], textures: { t: texture } })[0]?.message).toMatch(/got 8$/);
  });

  test("numbers in shared memory, or in a buffer that shrinks, are copied", () => {
    const shared = new Uint8Array(new SharedArrayBuffer(4)).fill(7);
    const shrinking = new Uint8Array(Reflect.construct(ArrayBuffer, [4, { maxByteLength: 8 }])).fill(7);
    for (const texels of [shared, shrinking]) {
      const scene = parseScene({ camera: CAMERA, objects: [], textures: { t: { width: 1, height: 1, texels } } });
      texels.fill(0);
      expect([...scene.textures.t!.texels]).toEqual([7, 7, 7, 7]);
    }
  });
});

describe("input of absurd size", () => {
  test("an array of four billion holes is refused unseen", () => {
    const message = "expected at most 1048576 entries, got 4000000000";
    expect(issuesOf({ camera: CAMERA, objects: new Array(4e9), lights: new Array(4e9) })).toEqual([
      { path: "objects", message },
      { path: "lights", message },
    ]);
    expect(issuesOf(new Array(4e9))).toHaveLength(1);
    expect(issuesOf({ camera: { position: new Array(4e9) }, objects: [] })).toHaveLength(1);
    const mesh = { type: "mesh", positions: new Array(4e9), indices: [], material: "m" };
    expect(issuesOf({ camera: CAMERA, materials: { m: {} }, objects: [mesh] })[0]?.path).toBe("objects[0].positions");
  });

  test("a misspelt material on a hundred thousand objects is told a hundred times, and counted", () => {
    const objects = Array.from({ length: 1e5 }, () => ({
      type: "sphere",
      center: [0, 0, 0],
      radius: 1,
      material: "x",
    }));
    const error = errorOf({ camera: CAMERA, objects });
    expect(error?.issues).toHaveLength(100);
    expect(error?.issueCount).toBe(1e5);
    expect(error?.message).toMatch(/^The scene has 100,000 errors:\n/);
    expect(error?.message).toMatch(/\n… and 99,900 more$/);
  });

  // Of a processor. Each is about a megabyte and takes a tenth of a second; what was quadratic, or handed every issue on from
  // level to level, took ten.
  const QUICK_MS = 1500;
  // A line has a path of at most six names of 40 characters and a list of at most nine such; three bytes each, if it must be.
  const MAX_MESSAGE_BYTES = 100 * 3 * (6 + 9) * 50;
  const many = <T>(count: number, make: (i: number) => T): T[] => Array.from({ length: count }, (_, i) => make(i));
  const named = <T>(count: number, make: (i: number) => T) =>
    Object.fromEntries(many(count, (i) => [`k${i}`, make(i)]));
  const long = "𝔵".repeat(2 ** 20);
  const hostile: Readonly<Record<string, () => object>> = {
    "a list of numbers for objects": () => ({ objects: many(2e5, Number) }),
    "empty objects": () => ({ objects: many(1e5, () => ({})) }),
    "unknown keys": () => named(2e5, Number),
    "unknown keys in each of a thousand materials": () => ({ materials: named(1000, () => named(200, Number)) }),
    "materials with everything wrong": () => ({ materials: named(2e4, () => ({ roughness: 2, ior: 0, mettalic: 1 })) }),
    "a name that is none of twenty thousand, on a thousand objects": () => ({
      materials: named(2e4, () => ({})),
      objects: many(1000, () => ({ type: "sphere", center: [0, 0, 0], radius: 1, material: "x" })),
    }),
    "textures that are none of many": () => ({ materials: named(2e4, () => ({ baseColorTexture: "x" })) }),
    "strings for coordinates": () => ({ objects: [{ type: "mesh", positions: many(3e5, () => "0"), indices: [] }] }),
    "lists in lists": () => JSON.parse(`{"objects": ${"[".repeat(2e5)}${"]".repeat(2e5)}}`),
    "objects in objects": () => JSON.parse(`{"materials": ${'{"a":'.repeat(2e5)}1${"}".repeat(2e5)}}`),
    "names of a million letters": () => ({ [long]: 0, materials: { [long]: { [long]: 0, masking: long } } }),
    "values of a million letters": () => ({ $schema: [long], objects: [{ type: long }], lights: long }),
    "a number of a million digits": () => ({ maxBounces: 2n ** 4_000_000n, environment: Symbol(long) }),
  };

  test.each(Object.keys(hostile))("%s: a short message, soon", (name) => {
    const input = hostile[name]!();
    const start = process.cpuUsage();
    const error = errorOf({ camera: CAMERA, objects: [], ...input });
    expect(process.cpuUsage(start).user / 1000).toBeLessThan(QUICK_MS);
    expect(error?.issues.length).toBeLessThanOrEqual(100);
    expect(error?.issueCount).toBeGreaterThanOrEqual(error!.issues.length);
    expect(new TextEncoder().encode(error?.message).length).toBeLessThan(MAX_MESSAGE_BYTES);
  });

  test("a picture of four thousand by four thousand texels is copied, not looked at", () => {
    const texels = new Uint8ClampedArray(4 * 4096 ** 2);
    texels[5] = 9;
    const start = process.cpuUsage();
    const scene = parseScene({ camera: CAMERA, objects: [], textures: { t: { width: 4096, height: 4096, texels } } });
    // To copy 64 MB takes 20 ms; one by one, 700.
    expect(process.cpuUsage(start).user / 1000).toBeLessThan(200);
    expect(scene.textures.t!.texels[5]).toBe(9);
    expect(scene.textures.t!.texels.buffer).not.toBe(texels.buffer);
    // What came out once is not copied again: the panel hands in the whole scene for every change of a colour.
    expect(parseScene(scene).textures.t!.texels).toBe(scene.textures.t!.texels);
  });

  test("a megabyte of text is shown in part", () => {
    const text = "x".repeat(2 ** 20);
    for (const { message } of issuesOf({ camera: text, objects: [], lights: [{ type: text }] })) {
      expect(message.length).toBeLessThan(100);
    }
  });

  test("a million good vertices parse", () => {
    const vertexCount = 1e6;
    const positions = new Array(3 * vertexCount).fill(1);
    const indices = Array.from({ length: 3 * vertexCount }, (_, i) => i % vertexCount);
    const objects = [{ type: "mesh", positions, indices, material: "m" }];
    const { objects: parsed } = parseScene({ camera: CAMERA, materials: { m: {} }, objects });
    expect(parsed[0]).toMatchObject({ type: "mesh" });
  });
});
