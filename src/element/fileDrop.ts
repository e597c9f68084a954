/** Who takes the files. */
export type FileDropTarget = {
  /** Rejects if they cannot be shown; the reason is then shown over the picture for a while. */
  readonly onFiles: (files: readonly File[]) => Promise<void>;
};

const INVITATION = "Drop to view";
const REASON_MS = 8000;

/**
 * Lets files be dropped on an element. While some are dragged over it, a frame says so.
 *
 * @param surface - takes the events.
 * @param root - the frame is put in there, as the part `drop`.
 * @param signal - ends it: the listeners and the frame go.
 */
export function bindFileDrop(
  surface: HTMLElement,
  root: ShadowRoot,
  target: FileDropTarget,
  signal: AbortSignal,
): void {
  const frame = createFrame(surface.ownerDocument);
  root.append(frame);
  signal.addEventListener("abort", () => frame.remove());

  let reasonTimer: ReturnType<typeof setTimeout> | undefined;
  const say = (text: string, isReason = false) => {
    clearTimeout(reasonTimer);
    frame.textContent = text;
    frame.hidden = text === "";
    frame.classList.toggle("reason", isReason);
    if (isReason) reasonTimer = setTimeout(() => say(""), REASON_MS);
  };
  const onOver = (event: DragEvent) => {
    if (!event.dataTransfer?.types.includes("Files")) return;
    event.preventDefault(); // which is what allows a drop
    event.dataTransfer.dropEffect = "copy";
    if (frame.textContent !== INVITATION) say(INVITATION);
  };
  surface.addEventListener("dragenter", onOver, { signal });
  surface.addEventListener("dragover", onOver, { signal });
  surface.addEventListener(
    "dragleave",
    (event) => {
      // Leaving for something within is not leaving. Outside of the element's own tree that is all one target.
      if (!(event.relatedTarget instanceof Node && surface.contains(event.relatedTarget))) say("");
    },
    { signal },
  );
  surface.addEventListener(
    "drop",
    (event) => {
      const files = [...(event.dataTransfer?.files ?? [])];
      if (files.length === 0) return;
      event.preventDefault(); // or the page would be left for the file
      say("");
      target.onFiles(files).catch((error: Error) => {
        if (!signal.aborted && error.name !== "AbortError") say(error.message, true);
      });
    },
    { signal },
  );
}

function createFrame(document: Document): HTMLElement {
  const frame = document.createElement("div");
  frame.className = "drop";
  frame.setAttribute("part", "drop");
  frame.setAttribute("role", "status");
  frame.hidden = true;
  return frame;
}
