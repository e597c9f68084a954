import type { Tree } from "@lezer/common";
import { parseScene, type Scene, SceneError } from "rt-viewer";
import { firstFault, parsePath, positionOf, type Range } from "./jsonPosition";

/** Something that is wrong with the text, and where. */
export type Problem = Range & {
  /** `objects[3].radius`; `""` for the text as a whole. */
  readonly path: string;
  readonly message: string;
};

export type Checked = { readonly problems: readonly Problem[]; readonly scene?: Scene };

/** Reads a scene from JSON. There is a scene if there are no problems. */
export function check(text: string, tree: Tree): Checked {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch (error) {
    const at = syntaxPosition(String(error), text, tree);
    const end = Math.min(text.length, at + 1);
    return { problems: [{ from: Math.max(0, end - 1), to: end, path: "", message: syntaxMessage(String(error)) }] };
  }
  try {
    parseScene(value);
    return { problems: [], scene: value as Scene };
  } catch (error) {
    if (!(error instanceof SceneError)) throw error;
    const problems = error.issues.map(({ path, message }) => ({
      ...positionOf(parsePath(path), text, tree),
      path,
      message,
    }));
    return { problems: problems.sort((a, b) => a.from - b.from) };
  }
}

/** Browsers say where JSON breaks in three ways, or not at all. */
function syntaxPosition(error: string, text: string, tree: Tree): number {
  const offset = /at position (\d+)/.exec(error)?.[1];
  if (offset !== undefined) return Number(offset);
  const [, line, column] = /at line (\d+) column (\d+)/.exec(error) ?? [];
  if (line === undefined) return firstFault(tree);
  const before = text.split("\n").slice(0, Number(line) - 1);
  return before.reduce((sum, { length }) => sum + length + 1, 0) + Number(column) - 1;
}

/** Without the excerpt and the position, which the editor shows better. */
function syntaxMessage(error: string): string {
  return error
    .replace(/^SyntaxError: (JSON\.parse: |JSON Parse error: )?/, "")
    .replace(/, (\.\.\.)?".*"(\.\.\.)? is not valid JSON$/s, "")
    .replace(/( in JSON)? at (position|line) .*$/s, "");
}
