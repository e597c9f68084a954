import type { FolderApi } from "tweakpane";

/** Adds an empty row to a folder, for content that Tweakpane has no blade for. */
export function addOwnBlade(folder: FolderApi): HTMLElement {
  const { element } = folder.addBlade({ view: "separator" });
  element.replaceChildren();
  return element;
}
