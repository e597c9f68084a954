import * as v from "valibot";
import { SceneError, type SceneIssue } from "../errors";
import { HOPELESS, isObject, MAX_FAULTY_ENTRIES } from "./containers";
import { show } from "./describe";
import { CameraSchema, type ResolvedCamera, type ResolvedScene, SceneSchema } from "./schema";

// More names than this make a list that nobody reads.
const MAX_LISTED_NAMES = 8;

/**
 * Checks a scene, as written in TypeScript or read from JSON, and fills in every default.
 *
 * @returns new data that shares nothing with the input. `materials` has no prototype, and holds every name an object uses.
 * @throws {SceneError} with every issue. Nothing else is thrown, whatever the input.
 */
export function parseScene(input: unknown): ResolvedScene {
  return parse(SceneSchema, input, findUnknownMaterials);
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

/** Every object that names a material that is not there. Takes a faulty scene too, and looks only at what is well-formed. */
function findUnknownMaterials(scene: unknown): SceneIssue[] {
  const objects = property(scene, "objects");
  const materials = property(scene, "materials") === undefined ? {} : property(scene, "materials");
  if (!Array.isArray(objects) || !isObject(materials)) return [];

  const names = Object.keys(materials);
  const listed = names.slice(0, MAX_LISTED_NAMES).map((name) => show(name));
  if (names.length > MAX_LISTED_NAMES) listed.push(`${names.length - MAX_LISTED_NAMES} more`);
  const choice = names.length === 0 ? "the scene has no materials" : `there are ${listed.join(", ")}`;

  const issues: SceneIssue[] = [];
  // The keys, because an array can be longer than the number of things in it.
  for (const i of Object.keys(objects)) {
    const name = property(property(objects, i), "material");
    if (typeof name !== "string" || Object.hasOwn(materials, name)) continue;
    if (issues.length === MAX_FAULTY_ENTRIES) return [...issues, { path: "objects", message: HOPELESS }];
    issues.push({ path: `objects[${i}].material`, message: `no material is named ${show(name)}; ${choice}` });
  }
  return issues;
}

function property(container: unknown, key: string): unknown {
  return isObject(container) || Array.isArray(container) ? Reflect.get(container, key) : undefined;
}

/** `objects[3].radius`, `materials["old gold"].ior`: the way to a value as JavaScript spells it. */
function formatPath(path: readonly v.IssuePathItem[]): string {
  return path.reduce((text, { key }) => {
    if (typeof key === "number") return `${text}[${key}]`;
    if (!/^[\p{ID_Start}$_][\p{ID_Continue}$]*$/u.test(String(key))) return `${text}[${show(key)}]`;
    return text === "" ? String(key) : `${text}.${key}`;
  }, "");
}
