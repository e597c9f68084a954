import { readFile } from "node:fs/promises";
import type { ESTree } from "vite";
import { type Docstring, declarationOf, importedFrom, parseSource, type Source } from "./docstrings";

/** Something that an entry of the package exports. */
export type Export = {
  readonly name: string;
  readonly docs: Docstring | undefined;
  /** Its declaration as TypeScript, without what is private. */
  readonly code: string;
};

/**
 * What a file of type declarations exports, by itself or from files beside it, in the order of its export statements.
 *
 * @throws {TypeError} if something it exports is nowhere.
 */
export async function readExports(file: URL): Promise<readonly Export[]> {
  const source = parseSource(await readFile(file, "utf8"));
  const exports: Export[] = [];
  for (const statement of source.body) {
    if (statement.type === "ExportAllDeclaration") {
      exports.push(...(await readExports(declarationsOf(statement.source.value, file))));
    } else if (statement.type === "ExportNamedDeclaration" && statement.declaration) {
      exports.push(...exportsOf(source, statement));
    } else if (statement.type === "ExportNamedDeclaration") {
      for (const { local, exported } of statement.specifiers) {
        const name = source.textOf(local);
        const from = statement.source?.value ?? importedFrom(source, name) ?? "";
        const found = (await readExports(declarationsOf(from, file))).find((each) => each.name === name);
        if (found === undefined) throw new TypeError(`${file.pathname} exports ${name}, which is not in "${from}".`);
        exports.push({ ...found, name: source.textOf(exported) });
      }
    }
  }
  return exports;
}

function declarationsOf(module: string, importer: URL): URL {
  return new URL(module.replace(/\.js$/, ".d.ts"), importer);
}

/**
 * A page on one entry of the package: every export, as its docstring and its declaration.
 *
 * @param before - sections that come first.
 */
export function describeEntry(entry: string, exports: readonly Export[], before: readonly string[]): string {
  const sections = exports.map(({ name, docs, code }) => {
    const isOfScene = /\bv\.Infer(In|Out)put</.test(code);
    const body = isOfScene ? "Its fields: [the scene format](scene.md)." : `\`\`\`ts\n${code}\n\`\`\``;
    return [`## ${name}`, describe(docs), body].filter((part) => part !== "").join("\n\n");
  });
  return [`# ${entry}`, ...before, ...sections].join("\n\n");
}

function describe(docs: Docstring | undefined): string {
  const tags = (docs?.tags ?? []).filter(({ name }) => ["param", "returns", "throws"].includes(name));
  const lines = tags.map(
    ({ name, text }) =>
      `- ${name === "param" ? "" : `${name} `}${text.replace(/^(\w+) - /, "`$1`: ").replace(/^\{(.*?)\}/, "`$1`")}`,
  );
  return [docs?.text ?? "", lines.join("\n")].filter((part) => part !== "").join("\n\n");
}

function exportsOf(source: Source, statement: ESTree.Node): Export[] {
  const declaration = declarationOf(statement);
  const docs = source.docstringOf(statement);
  const code = publicCode(source.textOf(declaration));
  if (declaration.type === "VariableDeclaration") {
    return declaration.declarations.map(({ id }) => ({ name: source.textOf(id).replace(/:.*/s, ""), docs, code }));
  }
  return "id" in declaration && declaration.id ? [{ name: source.textOf(declaration.id), docs, code }] : [];
}

/** Indented by two, without the members that TypeScript only lists to keep classes apart. */
function publicCode(declaration: string): string {
  const lines = declaration.replace(/^declare /, "").split("\n");
  const kept = lines.filter((line) => !/^ +(#private;|private |protected |\w+Callback\()/.test(line));
  return kept.map((line) => line.replace(/^( {4})+/, (indent) => " ".repeat(indent.length / 2))).join("\n");
}
