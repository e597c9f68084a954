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
