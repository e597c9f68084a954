import * as v from "valibot";
import { SceneError, type SceneIssue } from "../errors";
import { HOPELESS, isObject, MAX_FAULTY_ENTRIES } from "./containers";
import { show } from "./describe";
import { CameraSchema, type ResolvedCamera, type ResolvedScene, SceneSchema, TEXTURE_FIELDS } from "./schema";

// More names than this make a list that nobody reads.
const MAX_LISTED_NAMES = 8;

/**
 * Checks a scene, as written in TypeScript or read from JSON, and fills in every default.
 *
 * @returns new data that shares nothing with the input. `materials` has no prototype, and holds every name an object uses.
 * @throws {SceneError} with every issue. Nothing else is thrown, whatever the input.
 */
export function parseScene(input: unknown): ResolvedScene {
  return parse(SceneSchema, input, findUnknownNames);
}

/** Checks a camera alone, as `parseScene` does a scene. */
export function parseCamera(input: unknown): ResolvedCamera {
  return parse(CameraSchema, input, () => []);
}

function parse<T extends v.GenericSchema>(
  schema: T,
  input: unknown,
  findMore: (input: unknown) => SceneIssue[],
): v.InferOutput<T> {
  const issues: SceneIssue[] = [];
  try {
    const parsed = v.safeParse(schema, input);
    for (const { path, message } of parsed.issues ?? []) issues.push({ path: formatPath(path ?? []), message });
    for (const issue of findMore(parsed.success ? parsed.output : input)) issues.push(issue);
    if (parsed.success && issues.length === 0) return parsed.output;
  } catch (cause) {
    // The input itself threw: a getter, a revoked proxy.
    throw new SceneError([{ path: "", message: "expected plain data; reading it threw the error in `cause`" }], {
      cause,
    });
  }
  throw new SceneError(issues);
}

/** Every name of a material or texture that is not there. Takes a faulty scene too, and looks only at what is well-formed. */
function findUnknownNames(scene: unknown): SceneIssue[] {
  const objects = property(scene, "objects");
  const materials = property(scene, "materials");
  const issues: SceneIssue[] = [];
  // The keys, because an array can be longer than the number of things in it.
  for (const i of Array.isArray(objects) ? Object.keys(objects) : []) {
    if (issues.length === MAX_FAULTY_ENTRIES) return [...issues, { path: "objects", message: HOPELESS }];
    const object = property(objects, i);
    const name = property(object, "material");
    const path = `objects[${i}].material`;
    if (isNameIn(materials, name) === false) {
      issues.push({ path, message: unknownName("material", name, materials) });
    } else if (hasTexture(property(materials, String(name))) && property(object, "uvs") === undefined) {
      issues.push({ path, message: `${show(name)} has textures, which show on meshes with uvs only` });
    }
  }

  const textures = property(scene, "textures");
  for (const material of isObject(materials) ? Object.keys(materials) : []) {
    if (issues.length >= MAX_FAULTY_ENTRIES) return [...issues, { path: "materials", message: HOPELESS }];
    for (const field of TEXTURE_FIELDS) {
      const name = property(property(materials, material), field);
      if (isNameIn(textures, name) !== false) continue;
      const path = formatPath(["materials", material, field].map((key) => ({ key })));
      issues.push({ path, message: unknownName("texture", name, textures) });
    }
  }
  return issues;
}

function hasTexture(material: unknown): boolean {
  return TEXTURE_FIELDS.some((field) => property(material, field) !== undefined);
}

/** Whether a dictionary, {} by default, has something of this name; `undefined` if either is not well-formed. */
function isNameIn(dictionary: unknown = {}, name: unknown): boolean | undefined {
  return typeof name === "string" && isObject(dictionary) ? Object.hasOwn(dictionary, name) : undefined;
}

function unknownName(kind: string, name: unknown, dictionary: unknown = {}): string {
  const names = Object.keys(Object(dictionary));
  const listed = names.slice(0, MAX_LISTED_NAMES).map((known) => show(known));
  if (names.length > MAX_LISTED_NAMES) listed.push(`${names.length - MAX_LISTED_NAMES} more`);
  const choice = names.length === 0 ? `the scene has no ${kind}s` : `there are ${listed.join(", ")}`;
  return `no ${kind} is named ${show(name)}; ${choice}`;
}

function property(container: unknown, key: string): unknown {
  return isObject(container) || Array.isArray(container) ? Reflect.get(container, key) : undefined;
}

/** `objects[3].radius`, `materials["old gold"].ior`: the way to a value as JavaScript spells it. */
export function formatPath(path: readonly { readonly key: unknown }[]): string {
  return path.reduce((text, { key }) => {
    if (typeof key === "number") return `${text}[${key}]`;
    if (!/^[\p{ID_Start}$_][\p{ID_Continue}$]*$/u.test(String(key))) return `${text}[${show(key)}]`;
    return text === "" ? String(key) : `${text}.${key}`;
  }, "");
}
