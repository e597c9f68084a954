import { autocompletion } from "@codemirror/autocomplete";
import { json } from "@codemirror/lang-json";
import { syntaxHighlighting, syntaxTree } from "@codemirror/language";
import { type Diagnostic, linter, lintGutter } from "@codemirror/lint";
import { EditorState } from "@codemirror/state";
import { EditorView, hoverTooltip } from "@codemirror/view";
import { classHighlighter } from "@lezer/highlight";
import { basicSetup } from "codemirror";
import { type Checked, check } from "./check";
import { completeScene } from "./complete";
import { type JsonSchema, schemaOf } from "./schemaWalk";
import { wholeTree } from "./wholeTree";

const CHECK_DELAY_MS = 200;

export type EditorOptions = {
  readonly parent: HTMLElement;
  readonly schema: JsonSchema;
  /** Called a moment after the text has changed. */
  readonly onCheck: (checked: Checked) => void;
};

/**
 * An editor for scenes: marks mistakes where they are, completes by the schema, and explains keys under the pointer. Tab is
 * not bound, so it leaves the editor as it leaves everything else.
 */
export function createEditor({ parent, schema, onCheck }: EditorOptions): EditorView {
  const look = linter(
    (view) => {
      const { doc } = view.state;
      const tree = wholeTree(view.state);
      const checked = check(doc.toString(), tree);
      onCheck(checked);
      return checked.problems.map(toDiagnostic);
    },
    { delay: CHECK_DELAY_MS },
  );
  return new EditorView({
    parent,
    extensions: [
      basicSetup,
      json(),
      autocompletion({ override: [completeScene(schema)], icons: false }),
      explainKeys(schema),
      look,
      lintGutter(),
      EditorView.lineWrapping,
      syntaxHighlighting(classHighlighter),
      EditorState.tabSize.of(2),
      EditorView.contentAttributes.of({
        tabindex: "0",
        "aria-label": "Scene, as JSON",
        "aria-describedby": "editor-help",
      }),
    ],
  });
}

/** Puts another text in place of all there is. */
export function replaceText(view: EditorView, text: string): void {
  view.dispatch({
    changes: { from: 0, to: view.state.doc.length, insert: text },
    selection: { anchor: 0 },
    scrollIntoView: true,
  });
}

function toDiagnostic({ from, to, path, message }: Checked["problems"][number]): Diagnostic {
  return { from, to, severity: "error", message: path === "" ? message : `${path}: ${message}` };
}

function explainKeys(schema: JsonSchema) {
  return hoverTooltip((view, position) => {
    const node = syntaxTree(view.state).resolveInner(position);
    if (node.name !== "PropertyName") return null;
    const field = schemaOf(node, schema, view.state.doc.toString());
    if (!field?.description) return null;
    const text =
      field.default === undefined
        ? field.description
        : `${field.description} Default ${JSON.stringify(field.default)}.`;
    const create = () => {
      const dom = document.createElement("div");
      dom.className = "cm-explanation";
      dom.textContent = text;
      return { dom };
    };
    return { pos: node.from, end: node.to, create };
  });
}
