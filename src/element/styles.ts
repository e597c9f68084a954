/** The element's look. Everything that a page may want to restyle is a `::part` or a custom property. */
const CSS = /* css */ `
:host {
  display: block;
  position: relative;
  overflow: hidden;
  aspect-ratio: 4 / 3;
  min-width: 64px;
  min-height: 48px;
  background: #101114;
  color-scheme: dark;
}
:host([hidden]) { display: none; }

canvas {
  position: absolute;
  inset: 0;
  width: 100%;
  height: 100%;
  outline: none;
}
:host([controls]) canvas { cursor: grab; touch-action: none; }
:host([controls]) canvas:active { cursor: grabbing; }
canvas:focus-visible {
  outline: 2px solid var(--rt-viewer-focus-color, #6ea8fe);
  outline-offset: -2px;
}

.panel {
  position: absolute;
  inset: 8px 8px auto auto;
  width: min(208px, calc(100% - 16px));
  max-height: calc(100% - 16px);
  overflow: hidden auto;
  scrollbar-width: thin;
  scrollbar-color: #ffffff40 transparent;
  border-radius: 8px;
}

.drop {
  position: absolute;
  inset: 0;
  display: grid;
  place-items: center;
  padding: 16px;
  pointer-events: none;
  background: #17181cb3;
  color: #e8e9ed;
  font: 600 15px / 1.5 system-ui, sans-serif;
  overflow-wrap: anywhere;
  outline: 2px dashed var(--rt-viewer-focus-color, #6ea8fe);
  outline-offset: -10px;
}
.drop[hidden] { display: none; }
.drop.reason { place-items: end start; background: linear-gradient(#17181c00 60%, #17181ce6); outline: 0; color: #ff9d8a; }

.message {
  position: absolute;
  inset: 0;
  box-sizing: border-box;
  overflow: auto;
  padding: clamp(12px, 5%, 32px);
  display: flex;
  flex-direction: column;
  background: #17181cf2;
  color: #e8e9ed;
  font: 14px / 1.5 system-ui, sans-serif;
  overflow-wrap: anywhere;
}
.message[hidden] { display: none; }
.message > * { margin: 0; }
.message > :first-child { margin-top: auto; }
.message > :last-child { margin-bottom: auto; }
.message > p { font-weight: 600; font-size: 15px; color: #ff9d8a; }
.message > ul { padding: 0; margin-top: 6px; list-style: none; }
.message > ul > li { padding-block: 3px; border-top: 1px solid #ffffff1a; }
.message > ul > li:only-child { border: 0; }
.message.code > ul { font: 12.5px / 1.5 ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace; }
`;

let sheet: CSSStyleSheet | undefined;

/** The style sheet that all elements share; constructed, so that a page's content security policy need not allow it. */
export function elementStyles(): CSSStyleSheet {
  if (sheet === undefined) {
    sheet = new CSSStyleSheet();
    sheet.replaceSync(CSS);
  }
  return sheet;
}
