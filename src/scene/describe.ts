// Words for error messages: values, lists of names, and the name that was probably meant.

const MAX_SHOWN_LENGTH = 40;

/** `value` as it is best recognised in an error message: JSON-like, one level deep, about 40 characters, never throws on cycles. */
export function show(value: unknown): string {
  const text = showNested(value, 1);
  return text.length > MAX_SHOWN_LENGTH ? `${text.slice(0, MAX_SHOWN_LENGTH - 1)}…` : text;
}

/** `objects[3].radius`, `materials["old gold"].ior`: the way to a value as JavaScript spells it. Long names are cut. */
export function formatPath(keys: readonly unknown[]): string {
  return keys.reduce<string>((text, key) => {
    if (typeof key === "number") return `${text}[${key}]`;
    const name = String(key);
    if (name.length > MAX_SHOWN_LENGTH || !IDENTIFIER.test(name)) return `${text}[${show(name)}]`;
    return text === "" ? name : `${text}.${name}`;
  }, "");
}

const IDENTIFIER = /^[\p{ID_Start}$_][\p{ID_Continue}$]*$/u;

/** Names in quotes, as a list to choose from: `"a", "b" or "c"`. */
export function oneOf(names: readonly string[]): string {
  const quoted = names.map((name) => JSON.stringify(name));
  const last = quoted.pop() ?? "nothing";
  return quoted.length === 0 ? last : `${quoted.join(", ")} or ${last}`;
}

/** `; did you mean "roughness"?` if one of `known` is a likely spelling of `name`, else `""`. */
export function suggest(name: unknown, known: readonly string[]): string {
  if (typeof name !== "string" || name.length > MAX_SHOWN_LENGTH) return "";
  // A third of the letters may be wrong; with more, the suggestion is more often silly than helpful.
  let best = "";
  let bestDistance = Math.floor(name.length / 3) + 1;
  for (const candidate of known) {
    const distance = editDistance(name.toLowerCase(), candidate.toLowerCase());
    if (distance < bestDistance) [best, bestDistance] = [candidate, distance];
  }
  return best === "" ? "" : `; did you mean ${JSON.stringify(best)}?`;
}

function showNested(value: unknown, depth: number): string {
  if (value === undefined) return "nothing";
  if (typeof value === "string") return JSON.stringify(value.slice(0, MAX_SHOWN_LENGTH));
  // To write down a million digits takes seconds.
  if (typeof value === "bigint") return BigInt.asIntN(64, value) === value ? `${value}n` : "a bigint";
  if (typeof value === "function") return "a function";
  if (typeof value !== "object" || value === null) return String(value);

  // Only as many entries as can be shown are read, so that a huge array costs nothing.
  if (Array.isArray(value)) {
    if (depth === 0) return "[…]";
    const items = Array.from({ length: Math.min(value.length, MAX_SHOWN_LENGTH) }, (_, i) => value[i]);
    return `[${items.map((item) => showNested(item, depth - 1)).join(", ")}]`;
  }
  const kind = Object.prototype.toString.call(value).slice("[object ".length, -1);
  if (kind !== "Object") return `a ${kind}`;
  if (depth === 0) return "{…}";
  const entries = Object.keys(value).slice(0, MAX_SHOWN_LENGTH);
  const shown = entries.map((key) => `${showNested(key, 0)}: ${showNested(Reflect.get(value, key), depth - 1)}`);
  return `{${shown.join(", ")}}`;
}

/** Levenshtein distance: insertions, deletions and replacements that turn `a` into `b`. */
function editDistance(a: string, b: string): number {
  let row = Array.from({ length: b.length + 1 }, (_, j) => j);
  for (let i = 1; i <= a.length; i++) {
    const next = [i];
    for (let j = 1; j <= b.length; j++) {
      const replaced = row[j - 1]! + (a[i - 1] === b[j - 1] ? 0 : 1);
      next.push(Math.min(replaced, row[j]! + 1, next[j - 1]! + 1));
    }
    row = next;
  }
  return row[b.length]!;
}
