import { Pane, type TpPluginBundle } from "tweakpane";

/** What both themes share, and Tweakpane's variables for the dark one: glass over the picture, in the page's own type. */
const THEME = /* css */ `
.tp-rotv, .shader {
  --glass: rgb(19 20 24 / 88%);
  --paper: #15161a;
  --ink: #e6e8ee;
  --faint-ink: #a9adb8;
  --line: #9fd8b4;
  --rule: rgb(255 255 255 / 13%);
  --well: rgb(0 0 0 / 35%);
  --accent: #6ea8fe;
  --tint: 255 255 255;
  color-scheme: dark;
}
@media (prefers-color-scheme: light) {
  .tp-rotv, .shader {
    --glass: rgb(250 250 252 / 92%);
    --paper: #fcfcfd;
    --ink: #1d1f26;
    --faint-ink: #555a68;
    --line: #17733f;
    --rule: rgb(0 0 0 / 14%);
    --well: rgb(0 0 0 / 5%);
    --accent: #1a62d6;
    --tint: 20 24 40;
    color-scheme: light;
  }
}

.tp-rotv {
  --tp-base-background-color: var(--glass);
  --tp-base-border-radius: 8px;
  --tp-base-shadow-color: rgb(0 0 0 / 35%);
  --tp-base-font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif;
  --tp-blade-border-radius: 4px;
  --tp-blade-value-width: 136px;
  --tp-container-unit-size: 18px;
  --tp-container-unit-spacing: 3px;
  --tp-container-horizontal-padding: 2px;
  --tp-container-background-color: rgb(var(--tint) / 7%);
  --tp-container-background-color-hover: rgb(var(--tint) / 12%);
  --tp-container-background-color-focus: rgb(var(--tint) / 16%);
  --tp-container-background-color-active: rgb(var(--tint) / 20%);
  --tp-container-foreground-color: var(--ink);
  --tp-groove-foreground-color: rgb(var(--tint) / 12%);
  --tp-input-background-color: rgb(var(--tint) / 10%);
  --tp-input-background-color-hover: rgb(var(--tint) / 15%);
  --tp-input-background-color-focus: rgb(var(--tint) / 20%);
  --tp-input-background-color-active: rgb(var(--tint) / 24%);
  --tp-input-foreground-color: var(--ink);
  --tp-label-foreground-color: var(--faint-ink);
  --tp-monitor-background-color: var(--well);
  --tp-monitor-foreground-color: var(--line);
  --tp-button-background-color: rgb(var(--tint) / 14%);
  --tp-button-background-color-hover: rgb(var(--tint) / 20%);
  --tp-button-background-color-focus: rgb(var(--tint) / 24%);
  --tp-button-background-color-active: rgb(var(--tint) / 28%);
  --tp-button-foreground-color: var(--ink);
}
.tp-rotv_b { padding-left: 8px; }
.tp-rotv_t { text-align: left; contain: content; }
.tp-rotv_t, .tp-lblv_l, .tp-sglv_i, .graph-head { font-variant-numeric: tabular-nums; }
.tp-lblv_l { padding-right: 4px; white-space: nowrap; text-overflow: ellipsis; }
.tp-fldv_t { overflow: hidden; text-overflow: ellipsis; }
.tp-lstv_s option { background: Canvas; color: CanvasText; }
.tp-svpv_c { position: static; cursor: crosshair !important; } /* the element's own canvas is laid out otherwise */
.tp-rotv :is(button, input, select, textarea):focus-visible { outline: 2px solid var(--accent); outline-offset: -2px; }
.tp-mllv_i { white-space: pre-wrap; }
.tp-lblv:has(textarea) { align-items: start; }
@media (prefers-reduced-motion: reduce) {
  .tp-rotv * { transition-duration: 1ms !important; }
}
.offscreen { position: fixed; inset: 0 auto auto -99px; width: 1px; height: 1px; }

.graph { padding: 0 6px; }
.graph-head { display: flex; justify-content: space-between; height: 18px; line-height: 18px; contain: strict; }
.graph-value { color: var(--ink); }
.graph-note { color: var(--faint-ink); }
.graph-plot { position: relative; height: 52px; background: var(--well); border-radius: 4px; contain: strict; }
.graph-plot svg { display: block; width: 100%; height: 100%; fill: none; }
.graph-grid { stroke: var(--rule); }
.graph-guide { stroke: var(--faint-ink); stroke-dasharray: 3 3; opacity: 0.7; }
.graph-line { stroke: var(--line); stroke-width: 1.5; stroke-linejoin: round; }
.graph-plot span {
  position: absolute;
  padding: 1px 3px;
  color: var(--faint-ink);
  font-size: 9px;
  white-space: nowrap;
}
.graph-plot span.below { transform: translateY(-100%); }

.shader {
  box-sizing: border-box;
  width: min(880px, 100% - 32px);
  height: min(900px, 100% - 32px);
  padding: 0;
  border: 1px solid var(--rule);
  border-radius: 10px;
  background: var(--paper);
  color: var(--ink);
  font: 13px/1.4 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif;
}
.shader[open] { display: flex; flex-direction: column; }
.shader::backdrop { background: rgb(0 0 0 / 45%); }
.shader header { display: flex; align-items: baseline; gap: 10px; padding: 10px 10px 10px 16px; border-bottom: 1px solid var(--rule); }
.shader h2 { margin: 0; font: inherit; font-weight: 600; white-space: nowrap; }
.shader header span { flex: 1; color: var(--faint-ink); white-space: nowrap; overflow: hidden; text-overflow: ellipsis; }
.shader button {
  padding: 5px 12px;
  border: 0;
  border-radius: 6px;
  background: rgb(var(--tint) / 12%);
  color: inherit;
  font: inherit;
  white-space: nowrap;
  cursor: pointer;
}
.shader button:hover { background: rgb(var(--tint) / 20%); }
.shader pre {
  flex: 1;
  min-height: 0;
  margin: 0;
  padding: 12px 16px;
  overflow: auto;
  overscroll-behavior: contain;
  font: 12px/1.5 ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace;
  tab-size: 2;
}
.shader :focus-visible { outline: 2px solid var(--accent); outline-offset: -2px; }
`;

const sheets = new Map<string, CSSStyleSheet>();

/** Tweakpane's pane, with its style and ours in the tree that it is in, a shadow root or the document. */
export class StyledPane extends Pane {
  /**
   * Takes the style out of Tweakpane's bundle, which would put it into the head of the document: a shadow root does not see
   * it there, and a page with a strict content security policy does not allow it.
   */
  override registerPlugin({ css, ...bundle }: TpPluginBundle): void {
    super.registerPlugin(bundle);
    const root = this.element.getRootNode();
    if (root instanceof Document || root instanceof ShadowRoot) adopt(root, [css ?? "", THEME]);
  }
}

/** Each text once, whatever its number of panels. */
function adopt(root: Document | ShadowRoot, texts: readonly string[]): void {
  for (const sheet of texts.map(sheetOf)) {
    if (!root.adoptedStyleSheets.includes(sheet)) root.adoptedStyleSheets.push(sheet);
  }
}

function sheetOf(css: string): CSSStyleSheet {
  const known = sheets.get(css);
  if (known !== undefined) return known;
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(css);
  sheets.set(css, sheet);
  return sheet;
}
