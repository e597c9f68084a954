import { readdirSync, readFileSync } from "node:fs";
import { Ajv, type ValidateFunction } from "ajv";
import * as v from "valibot";
import { beforeAll, describe, expect, test } from "vitest";
import type { SceneError } from "../../../src/errors";
import { parseScene } from "../../../src/scene/parseScene";
import { TEXTURE_FIELDS } from "../../../src/scene/schema";
import { type JsonSchema, toJsonSchema } from "../../../tools/jsonSchema";
import { createSceneSchema } from "../../../tools/sceneSchema";

const SCENES = new URL("../../reference/scenes/", import.meta.url);

const MESH = { type: "mesh", positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], indices: [0, 1, 2], material: "full" };

/** Every type, and every field. */
const FULL_SCENE = {
  $schema: "../scene.schema.json",
  camera: {
    position: [0, 1, 5],
    target: [0, 0, 0],
    up: [0, 1, 0],
    verticalFov: 45,
    orthographicHeight: 3,
    aperture: 0.1,
    focusDistance: 4,
  },
  materials: {
    full: {
      baseColor: [1, 0.5, 0],
      metallic: 1,
      roughness: 0.5,
      ior: 1.5,
      emission: [1, 2, 3],
      doubleSided: true,
      unlit: false,
      alpha: 0.5,
      alphaMode: "mask",
      alphaCutoff: 0.25,
      masking: "smith",
      multiscatter: true,
      normalScale: -1,
      ...{ transmission: 0.5, thickness: 0.01, attenuationColor: [1, 0.5, 0], attenuationDistance: 2, dispersion: 0.4 },
      ...{ diffuseTransmission: 0.5, diffuseTransmissionColor: [0, 1, 0], specular: 0.5, specularColor: [2, 1, 0] },
      ...{ clearcoat: 0.5, clearcoatRoughness: 0.25, clearcoatNormalScale: -1 },
      ...{ sheenColor: [1, 0, 0.5], sheenRoughness: 0.5, anisotropy: 0.5, anisotropyRotation: -30 },
      ...{ iridescence: 1, iridescenceIor: 1.8, iridescenceThickness: 500, iridescenceThicknessMinimum: 0 },
      ...Object.fromEntries(TEXTURE_FIELDS.map((field) => [field, "dot"])),
      emissionTexture: { texture: "dot", uv: 1, offset: [0.5, 0], scale: [2, -1], rotation: 30 },
    },
    plain: {},
  },
  textures: {
    dot: { width: 1, height: 1, texels: [0, 128, 255, 255], wrapU: "clamp", wrapV: "mirror", filter: "nearest" },
  },
  objects: [
    { type: "sphere", center: [0, 0, 0], radius: 1, material: "plain" },
    { type: "plane", point: [0, 0, 0], normal: [0, 2, 0], material: "plain" },
    { type: "quad", corner: [0, 0, 0], edge1: [1, 0, 0], edge2: [0, 1, 0], material: "plain" },
    {
      type: "triangle",
      vertices: [
        [0, 0, 0],
        [1, 0, 0],
        [0, 1, 0],
      ],
      material: "plain",
    },
    { type: "box", center: [0, 0, 0], size: [1, 2, 3], rotationY: 30, material: "plain" },
    {
      ...MESH,
      normals: [0, 0, 1, 0, 0, 1, 0, 0, 1],
      uvs: [0, 0, 1, 0, 0, 1],
      uvs1: [0, 0, 1, 0, 0, 1],
      colors: Array(12).fill(0.5),
      tangents: [1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1],
    },
  ],
  lights: [
    { type: "point", position: [0, 3, 0], power: [1, 1, 1] },
    { type: "sphere", position: [0, 3, 0], radius: 0.1, power: [1, 1, 1] },
    {
      type: "spot",
      position: [0, 3, 0],
      direction: [0, -1, 0],
      intensity: [1, 1, 1],
      innerAngle: 0,
      outerAngle: 30,
      radius: 0.1,
    },
    { type: "directional", direction: [0, -1, 0], irradiance: [1, 1, 1], angularDiameter: 0.53 },
  ],
  environment: { radiance: [0.1, 0.1, 0.1] },
  maxBounces: 8,
};

/** What a fault may be: absent, of another kind, out of range, or almost right. */
const VALUES = [
  undefined,
  null,
  true,
  "x",
  "",
  -1,
  0,
  0.5,
  1e-30,
  1e30,
  16385,
  {},
  [],
  [1, 2],
  [0, 0, 0],
  [-1, 2, "3"],
];

function withSpot(fields: object): object {
  return { lights: [{ type: "spot", position: [0, 3, 0], direction: [0, -1, 0], ...fields }] };
}

/**
 * What only `parseScene` sees: rules that look at several values. Each with a scene that breaks it, and the beginning of what
 * `parseScene` says then.
 */
const BEYOND_SCHEMA: readonly [rule: string, scene: object, message: RegExp][] = [
  ["target is not position", { camera: { position: [0, 0, 0] } }, /^expected a point other than position/],
  ["up is not along the view", { camera: { position: [0, 5, 0] } }, /^expected a direction that is not parallel to/],
  [
    "a direction is longer than 1e-18",
    { camera: { position: [0, 0, 5], up: [0, 1e-30, 0] } },
    /^expected a vector that/,
  ],
  [
    "multiscatter needs smith",
    withMaterial({ multiscatter: true, masking: "schlick-beckmann" }),
    /^expected false with/,
  ],
  ["a spot has power or intensity", withSpot({}), /^expected this or intensity, got neither/],
  ["and not both", withSpot({ power: [1, 1, 1], intensity: [1, 1, 1] }), /^expected this or power, got both/],
  [
    "its inner cone is inside of the outer one",
    withSpot({ power: [1, 1, 1], innerAngle: 50 }),
    /^expected an angle less/,
  ],
  ["three numbers per vertex", withMesh({ positions: [0, 0] }), /^expected three numbers per vertex/],
  ["three indices per triangle", withMesh({ indices: [0, 1] }), /^expected three indices per triangle/],
  ["a normal per vertex", withMesh({ normals: [0, 0, 1] }), /^expected as many numbers as positions/],
  ["a uv per vertex", withMesh({ uvs: [0, 0] }), /^expected two numbers per vertex/],
  ["indices of vertices", withMesh({ indices: [0, 1, 3] }), /^expected an index of one of the \d+ vertices/],
  [
    "four numbers per texel",
    { textures: { t: { width: 2, height: 1, texels: [0] } } },
    /^expected \d+ numbers, four per texel/,
  ],
  ["materials by their names", { objects: [{ ...MESH, material: "gold" }] }, /^no material is named/],
  ["textures by their names", withMaterial({ baseColorTexture: "wood" }), /^no texture is named/],
  ["a second uv per vertex", withMesh({ uvs1: [0, 0] }), /^expected two numbers per vertex/],
  ["placed textures by their names", withMaterial({ baseColorTexture: { texture: "wood" } }), /^no texture is named/],
  ["a colour per vertex", withMesh({ colors: [0, 0, 0, 1] }), /^expected four numbers per vertex/],
  ["textures need uvs", { ...FULL_SCENE, objects: [MESH] }, /has textures, which show on meshes with uvs only$/],
  [
    "textures with uv 1 need uvs1",
    { ...FULL_SCENE, objects: [MESH] },
    /has emissionTexture with uv 1, which shows on meshes with uvs1 only$/,
  ],
];

let schema: JsonSchema;
let validate: ValidateFunction;
beforeAll(async () => {
  schema = await createSceneSchema();
  validate = new Ajv({ strict: true }).compile(schema);
});

test.each(readdirSync(SCENES))("the reference scene %s is valid, and names the schema", (name) => {
  const scene = JSON.parse(readFileSync(new URL(name, SCENES), "utf8"));
  expect(validate(scene), JSON.stringify(validate.errors)).toBe(true);
  const schemaUrl = new URL(scene.$schema, new URL(name, SCENES));
  expect(schemaUrl.pathname.endsWith("/dist/scene.schema.json"), schemaUrl.pathname).toBe(true);
});

test("a scene with every field is valid, and the schema knows no other field", () => {
  expect(issuesOf(FULL_SCENE)).toEqual([]);
  expect(validate(FULL_SCENE), JSON.stringify(validate.errors)).toBe(true);
  const used = new Set(pathsOf(FULL_SCENE).map((path) => path.at(-1)));
  expect(propertyNames(schema).filter((name) => !used.has(name))).toEqual([]);
});

test("whatever is wrong with one value, the schema and parseScene agree on it", () => {
  const isBeyond = (issue: string) => BEYOND_SCHEMA.some(([, , message]) => message.test(issue));
  const disagreements: string[] = [];
  let rejectedCount = 0;
  const compare = (path: readonly string[], value: unknown) => {
    const scene = replaced(path, value);
    const issues = issuesOf(scene);
    const isValid = validate(scene);
    rejectedCount += isValid ? 0 : 1;
    const agree = isValid ? issues.every(isBeyond) : issues.length > 0;
    if (!agree) disagreements.push(`${path.join(".")} = ${JSON.stringify(value)}: ${isValid ? issues : "is accepted"}`);
  };
  for (const path of [[], ...pathsOf(FULL_SCENE)]) {
    for (const value of VALUES) compare(path, value);
    compare([...path, "unknwon"], 1);
  }
  expect(disagreements).toEqual([]);
  expect(rejectedCount).toBeGreaterThan(1000);
});

describe("rules that look at several values are left to parseScene", () => {
  test.each(BEYOND_SCHEMA)("%s", (_, fields, message) => {
    const scene = { camera: { position: [0, 0, 5] }, objects: [], ...fields };
    expect(validate(scene), JSON.stringify(validate.errors)).toBe(true);
    expect(issuesOf(scene)).toContainEqual(expect.stringMatching(message));
  });
});

test("defaults and descriptions are those of the source", () => {
  const camera = (schema.properties as Record<string, JsonSchema>).camera!.properties as Record<string, JsonSchema>;
  expect(camera.verticalFov).toEqual({
    description: "The angle between the lower and the upper edge of the picture, in degrees.",
    type: "number",
    exclusiveMinimum: 0,
    exclusiveMaximum: 180,
    default: 45,
  });
});

test("every field but the types is described", () => {
  const undescribed: string[] = [];
  const visit = (node: JsonSchema): void => {
    for (const [name, property] of Object.entries((node.properties ?? {}) as Record<string, JsonSchema>)) {
      if (property.description === undefined && property.const === undefined) undescribed.push(name);
    }
    for (const child of Object.values(node))
      if (typeof child === "object" && child !== null) visit(child as JsonSchema);
  };
  visit(schema);
  expect(undescribed).toEqual([]);
});

test("a schema about which nothing is known is an error, not a schema that takes everything", () => {
  expect(() => toJsonSchema(v.custom(() => true))).toThrow(/"custom"/);
});

function withMaterial(fields: object): object {
  return { materials: { m: fields } };
}

function withMesh(fields: object): object {
  return { materials: { full: {} }, objects: [{ ...MESH, ...fields }] };
}

function issuesOf(scene: unknown): string[] {
  try {
    parseScene(scene);
    return [];
  } catch (error) {
    return (error as SceneError).issues.map(({ message }) => message);
  }
}

/** The way to every value in `value`. */
function pathsOf(value: unknown): string[][] {
  if (typeof value !== "object" || value === null) return [];
  return Object.entries(value).flatMap(([key, child]) => [[key], ...pathsOf(child).map((path) => [key, ...path])]);
}

/** The full scene as JSON would hold it, with one value in another's place; `undefined` leaves it out. */
function replaced(path: readonly string[], value: unknown): unknown {
  if (path.length === 0) return value ?? null;
  const scene = structuredClone(FULL_SCENE);
  const parent = path.slice(0, -1).reduce<unknown>((node, key) => Reflect.get(Object(node), key), scene);
  if (typeof parent === "object" && parent !== null) Reflect.set(parent, path.at(-1)!, value);
  return JSON.parse(JSON.stringify(scene));
}

function propertyNames(node: unknown): string[] {
  if (typeof node !== "object" || node === null) return [];
  const own = Object.keys((node as JsonSchema).properties ?? {});
  return [...own, ...Object.values(node).flatMap(propertyNames)];
}
