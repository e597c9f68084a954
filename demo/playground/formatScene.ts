const INDENT = "  ";
const MAX_LINE = 92;

/** JSON as people write scenes: a vector, a material or a small object on one line, what is longer on several. */
export function formatScene(value: unknown): string {
  return `${format(JSON.parse(JSON.stringify(value)), "")}\n`;
}

function format(value: unknown, indent: string): string {
  const line = inline(value);
  if (typeof value !== "object" || value === null) return line;
  if (Array.isArray(value) && !value.some((item) => typeof item === "object")) return line; // also a mesh's thousands
  const isFlat = indent !== "" && !Object.values(value).some(hasObjects);
  if (isFlat && indent.length + line.length <= MAX_LINE) return line;
  const inner = indent + INDENT;
  const [open, close] = Array.isArray(value) ? "[]" : "{}";
  const entries = Array.isArray(value)
    ? value.map((item) => format(item, inner))
    : Object.entries(value).map(([key, item]) => `${JSON.stringify(key)}: ${format(item, inner)}`);
  if (entries.length === 0) return `${open}${close}`;
  return `${open}\n${entries.map((entry) => inner + entry).join(",\n")}\n${indent}${close}`;
}

function inline(value: unknown): string {
  if (Array.isArray(value)) return `[${value.map(inline).join(", ")}]`;
  if (typeof value !== "object" || value === null) return JSON.stringify(value);
  const entries = Object.entries(value).map(([key, item]) => `${JSON.stringify(key)}: ${inline(item)}`);
  return entries.length === 0 ? "{}" : `{ ${entries.join(", ")} }`;
}

/** Whether it is an object, or a list of them: then what holds it is written on several lines. */
function hasObjects(value: unknown): boolean {
  if (Array.isArray(value)) return value.some(hasObjects);
  return typeof value === "object" && value !== null;
}
