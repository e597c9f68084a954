// Defines <rt-viewer>. The one module with a side effect; in Node, where there are no custom elements, it has none.

import type { RtViewerEventMap } from "./element/events";
import { RtViewerElement } from "./element/rtViewerElement";

export type {
  ConvergedDetail,
  DeviceLostDetail,
  ErrorDetail,
  LoadWarningsDetail,
  PickDetail,
  ProgressDetail,
  ReadyDetail,
  RtViewerEventMap,
} from "./element/events";
export type { LoadPhase, LoadProgressDetail } from "./element/loadProgress";
export { RtViewerElement };

const TAG = "rt-viewer";

// Two copies of the package on one page are no error: the first one stands.
if (globalThis.customElements !== undefined && customElements.get(TAG) === undefined) {
  customElements.define(TAG, RtViewerElement);
}

declare global {
  interface HTMLElementTagNameMap {
    "rt-viewer": RtViewerElement;
  }
  /** Those whose names no other element uses; `progress` and `error` are typed on the element itself. */
  interface HTMLElementEventMap extends Pick<RtViewerEventMap, "loadprogress" | "ready" | "converged" | "devicelost"> {}
}
