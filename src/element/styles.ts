// @lean css
/** The element's look. Everything that a page may want to restyle is a `::part` or a custom property. */
const CSS = /* css */ `
:host {
  display: block;
  position: relative;
  overflow: hidden;
  aspect-ratio: 4 / 3;
  min-width: 64px;
  min-height: 48px;
  --ground: var(--rt-viewer-background, #101114);
  --text: var(--rt-viewer-color, #e8e9ed);
  --alarm: var(--rt-viewer-error-color, #ff9d8a);
  --accent: var(--rt-viewer-accent-color, #6ea8fe);
  --line: #8885;
  background: var(--ground);
  color-scheme: dark;
}
:host([hidden]) { display: none; }
@media (prefers-color-scheme: light) {
  :host {
    --ground: var(--rt-viewer-background, #eeeff2);
    --text: var(--rt-viewer-color, #24262c);
    --alarm: var(--rt-viewer-error-color, #b3261e);
    --accent: var(--rt-viewer-accent-color, #1a5fd0);
    color-scheme: light;
  }
}
[hidden] { display: none !important; }

canvas {
  position: absolute;
  inset: 0;
  width: 100%;
  height: 100%;
  outline: none;
}
:host([controls]) canvas { cursor: grab; touch-action: var(--rt-viewer-touch-action, pan-y); }
:host([controls]) canvas:active { cursor: grabbing; }
canvas:focus-visible + .curtain, .message:focus-visible {
  outline: 2px solid var(--rt-viewer-focus-color, #6ea8fe);
  outline-offset: -2px;
  box-shadow: inset 0 0 0 3px #000c; /* seen over a bright picture too */
}

.curtain, .poster { position: absolute; inset: 0; pointer-events: none; }
.poster img, .poster ::slotted(*) { width: 100%; height: 100%; object-fit: cover; }
.poster.gone { opacity: 0; visibility: hidden; }
.progress {
  position: absolute;
  inset: auto 0 0;
  height: 3px;
  overflow: hidden;
  background: var(--line);
  animation: appear 1ms 300ms backwards;
}
.progress > div { height: 100%; background: var(--accent); transform-origin: 0 0; }
@keyframes appear { from { opacity: 0; } }
@media (prefers-reduced-motion: no-preference) {
  .poster.gone { transition: opacity 0.25s, visibility 0.25s; }
  .progress > div { transition: transform 0.15s; }
  .progress.unknown > div { width: 30%; animation: sweep 1.2s ease-in-out infinite alternate; }
}
@keyframes sweep { to { translate: 233.4%; } }

.panel {
  position: absolute;
  inset: 8px 8px auto auto;
  width: min(236px, calc(100% - 16px));
  max-height: calc(100% - 16px);
  overflow: hidden auto;
  scrollbar-width: thin;
  scrollbar-color: #ffffff40 transparent;
  border-radius: 8px;
  color-scheme: dark;
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
  background: var(--ground);
  color: var(--text);
  font: 14px / 1.5 system-ui, sans-serif;
  overflow-wrap: anywhere;
}
.message > div, .message > slot > div { margin-block: auto; }
.message ::slotted(*) { margin: auto; }
.message p { margin: 0; font-weight: 600; font-size: 15px; color: var(--alarm); }
.message ul { padding: 0; margin: 6px 0 0; list-style: none; }
.message li { padding-block: 3px; border-top: 1px solid var(--line); }
.message li:only-child { border: 0; }
.message.code ul { font: 12.5px / 1.5 ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace; }

.unseen { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
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
