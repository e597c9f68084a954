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

/**
 * Gives the tree that holds a panel Tweakpane's style and ours. Tweakpane itself puts its style into the head of the
 * document, where a shadow root does not see it.
 */
export function adoptPanelStyles(root: Document | ShadowRoot): void {
  const { head } = root instanceof Document ? root : root.ownerDocument;
  const own = root instanceof Document ? [] : [...head.querySelectorAll("style[data-tp-style]")];
  for (const css of [...own.map((style) => style.textContent ?? ""), THEME]) {
    const sheet = sheetOf(css);
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
