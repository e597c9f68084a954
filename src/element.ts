// Defines <rt-viewer>. The one module with a side effect; in Node, where there are no custom elements, it has none.

import { RtViewerElement } from "./element/rtViewerElement";

export type {
  ConvergedDetail,
  ErrorDetail,
  LoadWarningsDetail,
  ProgressDetail,
  ReadyDetail,
  RtViewerEventMap,
} from "./element/events";
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
}
