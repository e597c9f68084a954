const FEEDBACK_MS = 1500;

/**
 * Puts text on the clipboard. Where a page may not, or is not served securely, by way of a selection, as it was done before
 * there was an API for it.
 *
 * @param near - where the page has its focus: inside of the dialog that is open, if one is.
 * @returns whether it is there.
 */
export async function copyText(text: string, near: HTMLElement): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return copySelection(text, near);
  }
}

function copySelection(text: string, near: HTMLElement): boolean {
  const document = near.ownerDocument;
  const root = near.getRootNode();
  const focused = root instanceof ShadowRoot ? root.activeElement : document.activeElement;
  const area = document.createElement("textarea");
  area.className = "offscreen";
  area.value = text;
  near.append(area);
  area.select();
  const isCopied = document.execCommand("copy");
  area.remove();
  if (focused instanceof HTMLElement) focused.focus();
  return isCopied;
}

/**
 * Returns what to do when a button that copies is pressed: it says for a moment whether that went well.
 *
 * @param setTitle - sets what is written on the button.
 */
export function copier(text: () => string, near: HTMLElement, title: string, setTitle: (title: string) => void) {
  let timer: ReturnType<typeof setTimeout> | undefined;
  return async (): Promise<void> => {
    const isCopied = await copyText(text(), near);
    setTitle(isCopied ? "Copied" : "The browser refused");
    clearTimeout(timer);
    timer = setTimeout(() => setTitle(title), FEEDBACK_MS);
  };
}
