import { ensureSyntaxTree, syntaxTree } from "@codemirror/language";
import type { EditorState } from "@codemirror/state";
import type { Tree } from "@lezer/common";

// Long texts take some tens of milliseconds; a busy machine many times that.
const PARSE_BUDGET_MS = 500;

/** The syntax of all of the text, which the editor may have read in part. */
export function wholeTree(state: EditorState): Tree {
  return ensureSyntaxTree(state, state.doc.length, PARSE_BUDGET_MS) ?? syntaxTree(state);
}
