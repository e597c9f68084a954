import { describe, expect, test } from "vitest";
import { SceneError } from "../../../src/errors";
import { parseScene } from "../../../src/scene/parseScene";

const CAMERA = { position: [0, 0, 5] };

function issuesOf(input: unknown): SceneError["issues"] {
  try {
    parseScene(input);
  } catch (error) {
    if (error instanceof SceneError) return error.issues;
    throw error;
  }
  return [];
}

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

describe("input of absurd size", () => {
  test("an array of four billion holes is given up on", () => {
    const issues = issuesOf({ camera: CAMERA, objects: new Array(4e9), lights: new Array(4e9) });
    expect(issues).toHaveLength(2002);
    expect(issues[1000]).toEqual({ path: "objects", message: "has 1000 faulty entries; the rest was not checked" });
    expect(issuesOf(new Array(4e9))).toHaveLength(1);
    expect(issuesOf({ camera: { position: new Array(4e9) }, objects: [] })).toHaveLength(1);
  });

  test("a misspelt material on a hundred thousand objects is given up on", () => {
    const objects = Array.from({ length: 1e5 }, () => ({
      type: "sphere",
      center: [0, 0, 0],
      radius: 1,
      material: "x",
    }));
    const issues = issuesOf({ camera: CAMERA, objects });
    expect(issues).toHaveLength(1001);
    expect(issues.at(-1)?.path).toBe("objects");
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
