const DEFAULT_LABEL = "3D scene";
const KEYS_ID = "keys";
const KEYS = "Arrow keys turn the view, with Shift they move it. Plus and minus zoom.";

/** The words that say which keys move the view; they belong beside the canvas. */
export function createKeyHelp(document: Document): HTMLElement {
  const help = document.createElement("p");
  help.id = KEYS_ID;
  help.hidden = true; // a description is read all the same
  help.textContent = KEYS;
  return help;
}

/**
 * Says what the canvas is and does, to those who do not see it: an image, or with controls something that takes the keys
 * for itself.
 *
 * @param alt - what the picture shows, "" where nobody says.
 */
export function labelCanvas(canvas: HTMLCanvasElement, alt: string, hasControls: boolean): void {
  canvas.setAttribute("role", hasControls ? "application" : "img");
  canvas.setAttribute("aria-roledescription", hasControls ? "3D view" : "3D picture");
  canvas.setAttribute("aria-label", alt || DEFAULT_LABEL);
  if (hasControls) canvas.setAttribute("aria-describedby", KEYS_ID);
  else canvas.removeAttribute("aria-describedby");
}
