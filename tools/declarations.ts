import { existsSync } from "node:fs";
import { readdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";

/**
 * Gives the relative imports in a folder's type declarations their extensions: without them, TypeScript finds nothing where it
 * resolves as Node does.
 *
 * @throws {TypeError} if there is no declaration of that name.
 */
export async function addExtensions(folder: string): Promise<void> {
  const names = await readdir(folder, { recursive: true });
  for (const name of names.filter((each) => each.endsWith(".d.ts"))) {
    const path = join(folder, name);
    const text = await readFile(path, "utf8");
    const complete = text.replaceAll(
      /(\b(?:from|import) "|\bimport\(")(\.[^"]*)"/g,
      (_, before: string, to: string) => {
        const target = [`${to}.js`, `${to}/index.js`, to].find((each) => isDeclared(join(dirname(path), each)));
        if (target === undefined) throw new TypeError(`${path} imports "${to}", which is not there.`);
        return `${before}${target}"`;
      },
    );
    await writeFile(path, complete);
  }
}

function isDeclared(module: string): boolean {
  return module.endsWith(".js") && existsSync(module.replace(/\.js$/, ".d.ts"));
}
