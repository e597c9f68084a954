import { copier } from "./clipboard";

/**
 * Shows a program's text over the page, to be read, searched and copied. Escape, the button and a click beside it close it.
 *
 * @param container - gets the dialog, for as long as it is open.
 * @returns closes it.
 */
export function openShaderDialog(container: HTMLElement, wgsl: string): () => void {
  const create = <K extends keyof HTMLElementTagNameMap>(tag: K, text = ""): HTMLElementTagNameMap[K] => {
    const element = container.ownerDocument.createElement(tag);
    element.textContent = text;
    return element;
  };
  const dialog = create("dialog");
  dialog.className = "shader";
  dialog.setAttribute("aria-label", "Shader of this scene");

  const lineCount = wgsl.trimEnd().split("\n").length;
  const title = create("h2", "Shader");
  const size = create("span", `WGSL · ${lineCount} lines`);
  const copy = create("button", "Copy");
  copy.setAttribute("aria-live", "polite");
  const close = create("button", "Close");
  const header = create("header");
  header.append(title, size, copy, close);

  const code = create("pre", wgsl);
  code.tabIndex = 0; // so that the keyboard scrolls it
  dialog.append(header, code);

  copy.addEventListener(
    "click",
    copier(
      () => wgsl,
      dialog,
      "Copy",
      (text) => {
        copy.textContent = text;
      },
    ),
  );
  close.addEventListener("click", () => dialog.close());
  dialog.addEventListener("pointerdown", (event) => {
    if (event.target === dialog) dialog.close(); // its children cover it: what is left is the backdrop
  });
  dialog.addEventListener("keydown", (event) => event.stopPropagation()); // Escape is meant for the dialog alone
  dialog.addEventListener("close", () => dialog.remove());

  container.append(dialog);
  dialog.showModal();
  code.focus();
  return () => dialog.close();
}
