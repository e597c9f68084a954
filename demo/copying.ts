import { element } from "./page";

/** Puts text on the clipboard; where that is refused, shows it selected in `dialog`, to be copied by hand. */
export async function copyText(text: string, dialog: HTMLDialogElement): Promise<"copied" | "shown"> {
  try {
    await navigator.clipboard.writeText(text);
    return "copied";
  } catch {
    const area = dialog.querySelector("textarea")!;
    area.value = text;
    dialog.showModal();
    area.select();
    area.scrollTop = 0;
    return "shown";
  }
}

/** Says on the button, for a moment, that it has done its work, and in `#announcement` to those who listen. */
export function sayCopied(button: HTMLButtonElement, announcement: string): void {
  const label = button.dataset.label ?? button.textContent ?? "";
  button.dataset.label = label;
  button.textContent = "Copied ✓";
  element("#announcement").textContent = announcement;
  setTimeout(() => {
    button.textContent = label;
  }, 2500);
}
