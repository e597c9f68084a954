import type { SyntaxNode, Tree } from "@lezer/common";

/** A way into JSON: keys and indices. */
export type JsonPath = readonly (string | number)[];

export type Range = { readonly from: number; readonly to: number };

/** Takes a path apart that is written like JavaScript: `materials["old gold"].baseColor[1]`. */
export function parsePath(path: string): JsonPath {
  return [...path.matchAll(/\[(\d+)\]|\[("(?:[^"\\]|\\.)*")\]|([^.[\]]+)/gu)].map(([, index, quoted, name]) => {
    if (index !== undefined) return Number(index);
    return quoted === undefined ? name! : (JSON.parse(quoted) as string);
  });
}

/** Where in `text` a value stands, with its key; for one that is missing, what it is missing from. Cut at the line's end. */
export function positionOf(path: JsonPath, text: string, tree: Tree): Range {
  let node = rootValue(tree);
  let found: SyntaxNode | undefined = node;
  for (const step of path) {
    const next: SyntaxNode | undefined = node && child(node, step, text);
    if (next === undefined) break;
    found = next;
    node = next.name === "Property" ? valueIn(next) : next;
  }
  return found === undefined ? { from: 0, to: 0 } : firstLine(found, text);
}

/** The first place where the text stops being JSON. */
export function firstFault(tree: Tree): number {
  let fault = 0;
  const cursor = tree.cursor();
  do {
    if (cursor.type.isError) {
      fault = cursor.from;
      break;
    }
  } while (cursor.next());
  return fault;
}

export function rootValue(tree: Tree): SyntaxNode | undefined {
  return tree.topNode.firstChild ?? undefined;
}

/** The key of a `Property`, without its quotes; `""` where it is not finished. */
export function keyOf(property: SyntaxNode, text: string): string {
  const name = property.getChild("PropertyName");
  return name === null ? "" : stringOf(name, text);
}

/** The value of a `Property`, if it is there yet. */
export function valueIn(property: SyntaxNode): SyntaxNode | undefined {
  const last = property.lastChild;
  return last === null || last.name === "PropertyName" || last.type.isError ? undefined : last;
}

/** What a string says; a broken one says nothing. */
export function stringOf(node: SyntaxNode, text: string): string {
  try {
    return String(JSON.parse(text.slice(node.from, node.to)));
  } catch {
    return "";
  }
}

/** The `Property` of an object, or the item of a list. */
export function child(node: SyntaxNode, step: string | number, text: string): SyntaxNode | undefined {
  if (node.name === "Object") return node.getChildren("Property").find((property) => keyOf(property, text) === step);
  if (node.name === "Array" && typeof step === "number") return items(node)[step];
  return undefined;
}

function items(list: SyntaxNode): SyntaxNode[] {
  const found: SyntaxNode[] = [];
  for (let item = list.firstChild; item; item = item.nextSibling) {
    if (!item.type.isError && !/^[[\],]$/.test(item.name)) found.push(item);
  }
  return found;
}

function firstLine({ from, to }: Range, text: string): Range {
  const end = text.indexOf("\n", from);
  return { from, to: end < 0 ? to : Math.min(to, end) };
}
