import type { ResolvedCamera } from "../scene/schema";
import { orbitBy, panBy, type ZoomLimits, zoomBy, zoomLimitsFor } from "./orbit";

/** What the controls move. */
export type OrbitTarget = {
  /** The camera now, or `undefined` while there is none. */
  readonly camera: () => ResolvedCamera | undefined;
  /** Where the scene's author put it, which says what distances make sense. */
  readonly home: () => ResolvedCamera | undefined;
  readonly onChange: (camera: ResolvedCamera) => void;
};

type Point = { readonly x: number; readonly y: number };

const KEY_STEP_RADIANS = Math.PI / 36; // 5°
const KEY_ZOOM = 1.1;
const WHEEL_ZOOM_PER_PIXEL = 0.0015; // a notch of 100 px is a step of 16 %
const WHEEL_LINE_PIXELS = 16;
const PINCH_GAIN = 8;
const TOUCH_SLOP_PIXELS = 8; // less has no direction yet
const MAX_WHEEL_PIXELS = 300; // some mice send a whole page per notch

/**
 * Lets pointer, wheel and keyboard move a camera: drag turns, unless it is a touch that scrolls the page; right-drag,
 * shift-drag and two fingers pan; wheel and pinch zoom; arrow keys turn, with shift they pan; + and − zoom.
 *
 * @param surface - takes the events; its height is the measure of every gesture.
 * @param signal - ends it: every listener goes.
 */
export function bindOrbitControls(surface: HTMLElement, target: OrbitTarget, signal: AbortSignal): void {
  const move = (step: (camera: ResolvedCamera) => ResolvedCamera): void => {
    const camera = target.camera();
    if (camera === undefined) return;
    const moved = step(camera);
    if (moved !== camera) target.onChange(moved);
  };
  bindPointers(surface, target, move, signal);
  bindWheel(surface, target, move, signal);
  surface.addEventListener("keydown", (event) => onKey(event, target, move), { signal });
}

function limitsOf({ home, camera }: OrbitTarget): ZoomLimits | undefined {
  const from = home();
  return from && zoomLimitsFor(from, camera());
}

type Move = (step: (camera: ResolvedCamera) => ResolvedCamera) => void;

function bindPointers(surface: HTMLElement, target: OrbitTarget, move: Move, signal: AbortSignal): void {
  const pointers = new Map<number, Point>();
  /** A single touch of which it is not known yet whether it scrolls the page, and where it began. */
  let undecided: { readonly id: number; readonly from: Point } | undefined;

  surface.addEventListener(
    "pointerdown",
    (event) => {
      if (event.button === 1) return; // the middle button scrolls the page
      surface.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, pointOf(event));
      const isFirstTouch = event.pointerType === "touch" && pointers.size === 1;
      undecided = isFirstTouch ? { id: event.pointerId, from: pointOf(event) } : undefined;
    },
    { signal },
  );
  surface.addEventListener(
    "pointermove",
    (event) => {
      if (!pointers.has(event.pointerId)) return;
      const before = [...pointers.values()];
      pointers.set(event.pointerId, pointOf(event));
      // Some moves come before the browser takes a touch away to scroll: the view must not jump with them.
      if (undecided?.id === event.pointerId) {
        if (!isForView(undecided.from, pointOf(event), surface)) return;
        undecided = undefined;
      }
      const after = [...pointers.values()];
      const height = Math.max(1, surface.clientHeight);
      if (after.length === 1) dragOne(before[0]!, after[0]!, height, isPanning(event), move);
      if (after.length === 2) dragTwo(before, after, height, target, move);
    },
    { signal },
  );
  for (const type of ["pointerup", "pointercancel", "lostpointercapture"] as const) {
    surface.addEventListener(type, (event) => void pointers.delete(event.pointerId), { signal });
  }
  surface.addEventListener("contextmenu", (event) => event.preventDefault(), { signal });
}

/** Whether a touch has set out in a direction that the page leaves to the view (see `touch-action`). */
function isForView(from: Point, to: Point, surface: HTMLElement): boolean {
  const [across, upright] = [Math.abs(to.x - from.x), Math.abs(to.y - from.y)];
  if (Math.max(across, upright) < TOUCH_SLOP_PIXELS) return false;
  return across > upright || getComputedStyle(surface).touchAction === "none";
}

function dragOne(before: Point, after: Point, height: number, panning: boolean, move: Move): void {
  const right = (after.x - before.x) / height;
  const down = (after.y - before.y) / height;
  if (panning) move((camera) => panBy(camera, right, -down));
  else move((camera) => orbitBy(camera, -right * Math.PI, down * Math.PI));
}

function dragTwo(before: readonly Point[], after: readonly Point[], height: number, target: OrbitTarget, move: Move) {
  const [from, to] = [centreOf(before), centreOf(after)];
  const factor = spreadOf(before) / spreadOf(after);
  move((camera) => {
    const panned = panBy(camera, (to.x - from.x) / height, -(to.y - from.y) / height);
    return zoomBy(panned, factor, limitsOf(target));
  });
}

/** The wheel belongs to the page until the pointer has been moved here, so that scrolling past does not get stuck. */
function bindWheel(surface: HTMLElement, target: OrbitTarget, move: Move, signal: AbortSignal): void {
  let entered: Point | undefined;
  let isAimed = false;

  const onMove = (event: PointerEvent) => {
    // A page that scrolls under a resting pointer also sends these, always with the same place on the screen.
    entered ??= { x: event.screenX, y: event.screenY };
    isAimed ||= entered.x !== event.screenX || entered.y !== event.screenY;
  };
  const onPress = () => {
    isAimed = true;
  };
  const onLeave = () => {
    entered = undefined;
    isAimed = false;
  };
  surface.addEventListener("pointerenter", onMove, { signal });
  surface.addEventListener("pointermove", onMove, { signal });
  surface.addEventListener("pointerleave", onLeave, { signal });
  surface.addEventListener("pointerdown", onPress, { signal });
  surface.addEventListener(
    "wheel",
    (event) => {
      if (!isAimed && !surface.matches(":focus")) return;
      event.preventDefault();
      const factor = wheelZoom(event.deltaY, event.deltaMode === WheelEvent.DOM_DELTA_LINE, event.ctrlKey);
      move((camera) => zoomBy(camera, factor, limitsOf(target)));
    },
    { signal, passive: false },
  );
}

/**
 * How far one wheel event zooms, as a factor on the distance or the height.
 *
 * @param isPinch - browsers report a pinch on a trackpad as a wheel with `ctrlKey`, in much smaller steps.
 */
export function wheelZoom(delta: number, isInLines: boolean, isPinch: boolean): number {
  const pixels = delta * (isInLines ? WHEEL_LINE_PIXELS : 1) * (isPinch ? PINCH_GAIN : 1);
  return Math.exp(Math.min(MAX_WHEEL_PIXELS, Math.max(-MAX_WHEEL_PIXELS, pixels)) * WHEEL_ZOOM_PER_PIXEL);
}

function onKey(event: KeyboardEvent, target: OrbitTarget, move: Move): void {
  if (event.ctrlKey || event.metaKey || event.altKey) return; // the browser's own shortcuts
  const direction = ARROWS[event.key];
  if (direction !== undefined) {
    const { x, y } = direction;
    if (event.shiftKey) move((camera) => panBy(camera, -x / 20, -y / 20));
    else move((camera) => orbitBy(camera, x * KEY_STEP_RADIANS, y * KEY_STEP_RADIANS));
  } else if (event.key === "+" || event.key === "=") {
    move((camera) => zoomBy(camera, 1 / KEY_ZOOM, limitsOf(target)));
  } else if (event.key === "-" || event.key === "_") {
    move((camera) => zoomBy(camera, KEY_ZOOM, limitsOf(target)));
  } else {
    return;
  }
  event.preventDefault();
}

/** Where the camera goes: y up. */
const ARROWS: Readonly<Record<string, Point>> = {
  ArrowLeft: { x: -1, y: 0 },
  ArrowRight: { x: 1, y: 0 },
  ArrowUp: { x: 0, y: 1 },
  ArrowDown: { x: 0, y: -1 },
};

/** `buttons` has bit 1 set while the right button is down. */
function isPanning(event: PointerEvent): boolean {
  return event.shiftKey || (event.buttons & 2) !== 0;
}

function pointOf(event: PointerEvent): Point {
  return { x: event.clientX, y: event.clientY };
}

function centreOf([a, b]: readonly Point[]): Point {
  return { x: (a!.x + b!.x) / 2, y: (a!.y + b!.y) / 2 };
}

/** Distance of two fingers; at least a pixel, so that a ratio of two is finite. */
function spreadOf([a, b]: readonly Point[]): number {
  return Math.max(1, Math.hypot(a!.x - b!.x, a!.y - b!.y));
}
