import { boxOfEntry, type CanvasBox } from "./canvasSize";

/**
 * Tells whether the element can be seen: on screen, in a document that is not hidden. Calls once with the first answer,
 * then with every change.
 *
 * @param signal - ends it.
 */
export function watchVisibility(element: Element, onChange: (isVisible: boolean) => void, signal: AbortSignal): void {
  let isOnScreen = false;
  const { ownerDocument } = element;
  const tell = () => onChange(isOnScreen && ownerDocument.visibilityState === "visible");
  const observer = new IntersectionObserver((entries) => {
    isOnScreen = entries.at(-1)?.isIntersecting ?? false;
    tell();
  });
  observer.observe(element);
  ownerDocument.addEventListener("visibilitychange", tell, { signal });
  signal.addEventListener("abort", () => observer.disconnect());
}

/**
 * Tells, once, that the element is on screen or less than a screen away from it.
 *
 * @param signal - ends it.
 */
export function watchNearness(element: Element, onNear: () => void, signal: AbortSignal): void {
  const observer = new IntersectionObserver(
    (entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      observer.disconnect();
      onNear();
    },
    { rootMargin: "100%" },
  );
  observer.observe(element);
  signal.addEventListener("abort", () => observer.disconnect());
}

/**
 * Tells whether the visitor asked for less motion, now and with every change.
 *
 * @param signal - ends it.
 */
export function watchReducedMotion(onChange: (isReduced: boolean) => void, signal: AbortSignal): void {
  const query = matchMedia("(prefers-reduced-motion: reduce)");
  query.addEventListener("change", () => onChange(query.matches), { signal });
  onChange(query.matches);
}

/**
 * Tells the box of an element in physical pixels where the browser knows them, now and with every change.
 *
 * @param signal - ends it.
 */
export function watchBox(element: Element, onChange: (box: CanvasBox) => void, signal: AbortSignal): void {
  const observer = new ResizeObserver((entries) => {
    const entry = entries.at(-1);
    if (entry !== undefined) onChange(boxOfEntry(entry, globalThis.devicePixelRatio));
  });
  observer.observe(element, knowsDevicePixels() ? { box: "device-pixel-content-box" } : {});
  signal.addEventListener("abort", () => observer.disconnect());
}

/** The box of an element at this moment, before an observer has spoken. */
export function currentBox(element: Element): CanvasBox {
  const { width, height } = element.getBoundingClientRect();
  return { width, height, pixelRatio: globalThis.devicePixelRatio };
}

/** Not in Safari, which rejects the option. */
function knowsDevicePixels(): boolean {
  return "devicePixelContentBoxSize" in ResizeObserverEntry.prototype;
}
