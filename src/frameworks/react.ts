// Defines <rt-viewer>, and tells JSX of React 19 what it takes. Listeners have lower-case names: onready, onconverged, …

import "../element";
import type { DetailedHTMLProps, HTMLAttributes } from "react";
import type { RtViewerElement } from "../element/rtViewerElement";
import type { RtViewerAttributes, RtViewerListeners, RtViewerProperties } from "./attributes";

export type { RtViewerAttributes, RtViewerListeners, RtViewerProperties };

/** What `<rt-viewer>` takes in JSX. */
export type RtViewerProps = DetailedHTMLProps<HTMLAttributes<RtViewerElement>, RtViewerElement> &
  RtViewerAttributes &
  RtViewerProperties &
  RtViewerListeners;

declare module "react" {
  namespace JSX {
    interface IntrinsicElements {
      "rt-viewer": RtViewerProps;
    }
  }
}
