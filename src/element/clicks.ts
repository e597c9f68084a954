// How far a pointer may stray between down and up, in CSS pixels, to have clicked; a finger is less steady.
const SLACK = { mouse: 4, touch: 10 } as const;

/** A place on an element, as shares of its width and height from the top left. */
export type Place = { readonly x: number; readonly y: number };

/**
 * Tells where an element is clicked or tapped: pressed and let go in one place, by the main button or one finger alone. A drag
 * is none, nor is a touch that scrolls the page.
 *
 * @param signal - ends it.
 */
export function watchClicks(surface: HTMLElement, onClick: (place: Place) => void, signal: AbortSignal): void {
  let down: PointerEvent | undefined;
  const pointers = new Set<number>();

  const onDown = (event: PointerEvent) => {
    pointers.add(event.pointerId);
    const isPlain = event.button === 0 && !event.shiftKey && !event.ctrlKey && !event.metaKey && !event.altKey;
    down = isPlain && pointers.size === 1 ? event : undefined;
  };
  const onMove = (event: PointerEvent) => {
    if (down?.pointerId === event.pointerId && hasStrayed(down, event)) down = undefined;
  };
  const onUp = (event: PointerEvent) => {
    pointers.delete(event.pointerId);
    const start = down;
    if (start?.pointerId !== event.pointerId) return;
    down = undefined;
    if (hasStrayed(start, event)) return;
    const { left, top, width, height } = surface.getBoundingClientRect();
    if (width > 0 && height > 0) onClick({ x: (event.clientX - left) / width, y: (event.clientY - top) / height });
  };
  const onCancel = (event: PointerEvent) => {
    pointers.delete(event.pointerId);
    down = undefined;
  };
  surface.addEventListener("pointerdown", onDown, { signal });
  surface.addEventListener("pointermove", onMove, { signal });
  surface.addEventListener("pointerup", onUp, { signal });
  surface.addEventListener("pointercancel", onCancel, { signal });
  surface.addEventListener("pointerleave", onCancel, { signal });
}

function hasStrayed(from: PointerEvent, to: PointerEvent): boolean {
  const slack = from.pointerType === "touch" ? SLACK.touch : SLACK.mouse;
  return Math.hypot(to.clientX - from.clientX, to.clientY - from.clientY) > slack;
}
