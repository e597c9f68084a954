import type { PathTracer } from "../renderer/pathTracer";
import type { Light, SceneObject } from "../scene/schema";
import type { LoadProgressDetail } from "./loadProgress";

/**
 * `ready`: the scene is loaded and compiled and its first picture is on the page. Once per scene, once
 * per change of the variant, and again with a new tracer after the device was lost.
 */
export type ReadyDetail = {
  readonly tracer: PathTracer;
  /** Milliseconds from the moment the scene was asked for (the element connected, `src`, `scene` or `variantName` set, a device lost). */
  readonly milliseconds: number;
};

/** `progress`: more samples are in the picture. At most ten times a second. */
export type ProgressDetail = {
  /** Samples per pixel so far. */
  readonly samples: number;
  /** Estimated relative RMSE of the picture; `Infinity` until known. */
  readonly error: number;
};

/** `converged`: `targetError` or `maxSamples` has been reached; sampling rests until something changes. */
export type ConvergedDetail = ProgressDetail;

/** `error`: the scene cannot be shown. The element says why in its place. */
export type ErrorDetail = {
  /** A `SceneError` lists the first 100 issues and counts all; a `WebGpuError` is about the device; otherwise the file could not be read. */
  readonly error: Error;
};

/**
 * `devicelost`: the browser took the GPU away. The element shows the same scene from the same camera again by itself, on a
 * new device: `ready` follows, or `error` where there is none any more, or where the scene has lost the device five times in a
 * row. `reset()`, or setting a scene, then tries again.
 */
export type DeviceLostDetail = {
  /** What the browser says about it; may be "". */
  readonly message: string;
  /** How often this has happened to the element. */
  readonly count: number;
};

/**
 * `pick`: an object or a light of the scene has been chosen, in the picture or in the panel, whose knobs it now has; or none
 * any more. `index` is its place in `objects` or `lights`.
 */
export type PickDetail =
  | { readonly kind: "object"; readonly index: number; readonly object: SceneObject }
  | { readonly kind: "light"; readonly index: number; readonly light: Light }
  | { readonly kind: "none" };

/** `loadwarnings`: a file was read, and has something that is not shown, or not as it should be. */
export type LoadWarningsDetail = {
  /** One sentence each. */
  readonly warnings: readonly string[];
};

/** The events of `<rt-viewer>`. None of them bubbles. */
export interface RtViewerEventMap {
  loadprogress: CustomEvent<LoadProgressDetail>;
  ready: CustomEvent<ReadyDetail>;
  progress: CustomEvent<ProgressDetail>;
  converged: CustomEvent<ConvergedDetail>;
  devicelost: CustomEvent<DeviceLostDetail>;
  error: CustomEvent<ErrorDetail>;
  pick: CustomEvent<PickDetail>;
  loadwarnings: CustomEvent<LoadWarningsDetail>;
}

/** Every event an `<rt-viewer>` can receive: its own, and those of any HTML element. */
type Events = RtViewerEventMap & Omit<HTMLElementEventMap, keyof RtViewerEventMap>;

/** An HTML element whose listeners are given the events of `<rt-viewer>`. */
export interface RtViewerEventTarget extends HTMLElement {
  addEventListener<K extends keyof Events>(
    type: K,
    listener: (this: this, event: Events[K]) => void,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  removeEventListener<K extends keyof Events>(
    type: K,
    listener: (this: this, event: Events[K]) => void,
    options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
}

/** Fires an event of `<rt-viewer>`. */
export function fire<K extends keyof RtViewerEventMap>(
  viewer: RtViewerEventTarget,
  type: K,
  detail: RtViewerEventMap[K]["detail"],
): void {
  viewer.dispatchEvent(new CustomEvent(type, { detail }));
}
