import { Pane, type TpPluginBundle } from "tweakpane";

/** Tweakpane's theme variables: dark glass over the picture, in the page's own type. */
const THEME = /* css */ `
.tp-rotv {
  --tp-base-background-color: rgb(19 20 24 / 88%);
  --tp-base-border-radius: 8px;
  --tp-base-shadow-color: rgb(0 0 0 / 35%);
  --tp-base-font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif;
  --tp-blade-border-radius: 4px;
  --tp-blade-value-width: 108px;
  --tp-container-unit-size: 18px;
  --tp-container-unit-spacing: 3px;
  --tp-container-horizontal-padding: 2px;
  --tp-container-background-color: rgb(255 255 255 / 7%);
  --tp-container-background-color-hover: rgb(255 255 255 / 12%);
  --tp-container-background-color-focus: rgb(255 255 255 / 16%);
  --tp-container-background-color-active: rgb(255 255 255 / 20%);
  --tp-container-foreground-color: #e6e8ee;
  --tp-groove-foreground-color: rgb(255 255 255 / 12%);
  --tp-input-background-color: rgb(255 255 255 / 10%);
  --tp-input-background-color-hover: rgb(255 255 255 / 15%);
  --tp-input-background-color-focus: rgb(255 255 255 / 20%);
  --tp-input-background-color-active: rgb(255 255 255 / 24%);
  --tp-input-foreground-color: #e6e8ee;
  --tp-label-foreground-color: #a9adb8;
  --tp-monitor-background-color: rgb(0 0 0 / 35%);
  --tp-monitor-foreground-color: #9fd8b4;
  --tp-button-background-color: rgb(255 255 255 / 14%);
  --tp-button-background-color-hover: rgb(255 255 255 / 20%);
  --tp-button-background-color-focus: rgb(255 255 255 / 24%);
  --tp-button-background-color-active: rgb(255 255 255 / 28%);
  --tp-button-foreground-color: #e6e8ee;
}
.tp-rotv_b { padding-left: 8px; }
.tp-rotv_t { text-align: left; }
.tp-rotv_t, .tp-lblv_l, .tp-sglv_i { font-variant-numeric: tabular-nums; }
.tp-lblv_l { padding-right: 4px; white-space: nowrap; text-overflow: ellipsis; }
.tp-rotv button:focus-visible, .tp-rotv input:focus-visible { outline: 2px solid #6ea8fe; outline-offset: -2px; }
.tp-mllv_i { white-space: pre-wrap; }
.tp-lblv:has(textarea) { align-items: start; }
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
