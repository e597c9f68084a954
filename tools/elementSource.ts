import { readFile } from "node:fs/promises";
import type { ESTree } from "vite";
import { type Docstring, declarationOf, importedFrom, parseSource, type Source } from "./docstrings";

/** A public property or method of the element's class, as its source has it. */
export type Member = {
  readonly kind: "field" | "method";
  readonly name: string;
  /** Of a property, as it is read; of a method, what it returns. */
  readonly type: string;
  readonly isReadOnly: boolean;
  readonly docs: Docstring | undefined;
};

/** An event the element fires. */
export type EventSource = { readonly name: string; readonly type: string; readonly description: string };

/** What the browser calls, not the page. */
const isLifecycle = (name: string) => /^(constructor|\w+Callback)$/.test(name);

/**
 * Reads a class and those it extends, as far as they are in files beside it.
 *
 * @returns the public members that a page uses on an element, the base class's first, and the docstrings of the classes.
 */
export async function readClass(
  file: URL,
  name: string,
): Promise<{ readonly members: readonly Member[]; readonly docs: readonly Docstring[] }> {
  const source = parseSource(await readFile(file, "utf8"));
  for (const statement of source.body) {
    const declaration = declarationOf(statement);
    if (declaration.type !== "ClassDeclaration" || declaration.id?.name !== name) continue;
    const base = declaration.superClass?.type === "Identifier" ? declaration.superClass.name : "";
    const baseFile = importedFrom(source, base);
    const inherited = baseFile ? await readClass(new URL(`${baseFile}.ts`, file), base) : { members: [], docs: [] };
    const docstring = source.docstringOf(statement);
    const own = publicMembers(source, declaration);
    return {
      members: [...inherited.members, ...own],
      docs: [...inherited.docs, ...(docstring ? [docstring] : [])],
    };
  }
  throw new TypeError(`There is no class ${name} in ${file.pathname}.`);
}

/** The events in an interface whose values are `CustomEvent<Detail>`, described by the docstrings of their details' types. */
export async function readEvents(file: URL, interfaceName: string): Promise<readonly EventSource[]> {
  const source = parseSource(await readFile(file, "utf8"));
  const events: EventSource[] = [];
  for (const statement of source.body) {
    const declaration = declarationOf(statement);
    if (declaration.type !== "TSInterfaceDeclaration" || declaration.id.name !== interfaceName) continue;
    for (const member of declaration.body.body) {
      if (member.type !== "TSPropertySignature" || !member.typeAnnotation) continue;
      const type = source.textOf(member.typeAnnotation.typeAnnotation);
      const detail = await descriptionOfType(file, source, /<(\w+)>/.exec(type)?.[1] ?? "");
      const description = capitalized(detail.replace(/^`[\w-]+`: /, ""));
      events.push({ name: source.textOf(member.key).replaceAll('"', ""), type, description });
    }
  }
  return events;
}

/** The docstring of a type that is declared in a file, or in one from which the file imports it. */
async function descriptionOfType(file: URL, source: Source, name: string): Promise<string> {
  for (const statement of source.body) {
    const declaration = declarationOf(statement);
    if (declaration.type !== "TSTypeAliasDeclaration" || declaration.id.name !== name) continue;
    return source.docstringOf(statement)?.text ?? "";
  }
  const module = importedFrom(source, name);
  if (module === undefined) return "";
  const imported = new URL(`${module}.ts`, file);
  return descriptionOfType(imported, parseSource(await readFile(imported, "utf8")), name);
}

function publicMembers(source: Source, { body }: ESTree.Class): Member[] {
  const setters = new Set<string>();
  const members: Omit<Member, "isReadOnly">[] = [];
  for (const member of body.body) {
    if (member.type !== "MethodDefinition" || member.static || member.key.type !== "Identifier") continue;
    const { name } = member.key;
    if ((member.accessibility ?? "public") !== "public" || isLifecycle(name)) continue;
    if (member.kind === "set") {
      setters.add(name);
      continue;
    }
    const { returnType } = member.value;
    const type = returnType ? source.textOf(returnType.typeAnnotation) : "unknown";
    members.push({ kind: member.kind === "get" ? "field" : "method", name, type, docs: source.docstringOf(member) });
  }
  return members.map((member) => ({ ...member, isReadOnly: !setters.has(member.name) }));
}

function capitalized(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}
