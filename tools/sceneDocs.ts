import type { JsonSchema } from "./jsonSchema";

/** Beyond this a bound is what fits the shader, and of no interest to readers. */
const HUGE = 1e18;

/** A page on the scene format: a table of fields for each kind of object in it. */
export function describeScene(schema: JsonSchema): string {
  const intro = [
    "# The scene format",
    schema.description,
    "`?` marks fields that may be left out. In a file, `$schema` may be the address of `rt-viewer/scene.schema.json`, by which " +
      "editors complete and check what is written.",
  ];
  return [...intro, ...describeObject("scene", { ...schema, description: undefined })].join("\n\n");
}

/** A section on an object, and one on each object in it. */
function describeObject(path: string, schema: JsonSchema): string[] {
  const properties = Object.entries((schema.properties ?? {}) as Record<string, JsonSchema>);
  const required = (schema.required ?? []) as readonly string[];
  const rows = properties.map(([name, property]) => {
    const isRequired = required.includes(name);
    const value = property.default === undefined ? "" : `\`${JSON.stringify(property.default)}\``;
    return `| \`${name}\`${isRequired ? "" : "?"} | ${typeText(property)} | ${value} | ${property.description ?? ""} |`;
  });
  const table = ["| field | | default | |", "|---|---|---|---|", ...rows].join("\n");
  const section = [`## ${path}`, schema.description, table].filter((part) => typeof part === "string");
  // Fields that hold the same are described once.
  const namesOf = new Map<string, [names: string[], JsonSchema]>();
  for (const [name, property] of properties) {
    const key = JSON.stringify({ ...property, description: undefined });
    namesOf.set(key, [[...(namesOf.get(key)?.[0] ?? []), name], property]);
  }
  const inner = [...namesOf.values()].flatMap(([names, property]) =>
    describeInner(path === "scene" ? names.join(", ") : `${path}.${names.join(", ")}`, property),
  );
  return [...section, ...inner] as string[];
}

function describeInner(path: string, schema: JsonSchema): string[] {
  if (schema.properties !== undefined) return describeObject(path, schema);
  const said = objectOrString(schema);
  if (said !== undefined) return describeObject(path, said);
  if (schema.anyOf !== undefined)
    return alternatives(schema).flatMap((each) => describeObject(`${path}: ${typeOf(each)}`, each));
  if (isSchema(schema.additionalProperties)) return describeInner(`${path}.NAME`, schema.additionalProperties);
  if (isSchema(schema.items)) return describeInner(`${path}[]`, schema.items);
  return [];
}

function typeText(schema: JsonSchema): string {
  if (schema.const !== undefined) return `\`${JSON.stringify(schema.const)}\``;
  if (Array.isArray(schema.enum)) return schema.enum.map((value) => `\`${JSON.stringify(value)}\``).join(", ");
  if (objectOrString(schema) !== undefined) return "string or object";
  if (schema.anyOf !== undefined) return `one of ${alternatives(schema).map(typeOf).join(", ")}`;
  if (isSchema(schema.additionalProperties)) return "by name";
  if (isSchema(schema.items)) {
    const item = typeText(schema.items);
    return schema.maxItems === undefined ? `list of ${item}` : `${schema.maxItems} × ${item}`;
  }
  return `${schema.type}${rangeText(schema)}`;
}

function rangeText(schema: JsonSchema): string {
  const { minimum = -HUGE, maximum = HUGE, exclusiveMinimum, exclusiveMaximum } = schema as Record<string, number>;
  if (exclusiveMinimum !== undefined || exclusiveMaximum !== undefined) {
    const least = exclusiveMinimum === undefined ? `≥ ${minimum}` : `> ${exclusiveMinimum}`;
    return ` ${least}, < ${exclusiveMaximum ?? maximum}`;
  }
  if (minimum <= -HUGE && maximum >= HUGE) return "";
  if (maximum >= HUGE) return minimum > 0 && minimum <= 1 / HUGE ? " > 0" : ` ≥ ${minimum}`;
  return ` ${minimum}…${maximum}`;
}

/** The object in whose place there may be a string. */
function objectOrString(schema: JsonSchema): JsonSchema | undefined {
  const [first, second] = (schema.anyOf ?? []) as readonly JsonSchema[];
  return first?.type === "string" ? second : undefined;
}

function alternatives(schema: JsonSchema): readonly JsonSchema[] {
  return schema.anyOf as readonly JsonSchema[];
}

/** The name in the field `type`. */
function typeOf(schema: JsonSchema): string {
  return String((schema.properties as Record<string, JsonSchema>).type?.const);
}

function isSchema(value: unknown): value is JsonSchema {
  return typeof value === "object" && value !== null;
}
