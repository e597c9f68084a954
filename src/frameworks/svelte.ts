// Defines <rt-viewer>, and tells Svelte 5 what it takes: onready={…}, scene={…}, …

import "../element";
import type { HTMLAttributes } from "svelte/elements";
import type { RtViewerElement } from "../element/rtViewerElement";
import type { RtViewerAttributes, RtViewerListeners, RtViewerProperties } from "./attributes";

export type { RtViewerAttributes, RtViewerListeners, RtViewerProperties };

/** What `<rt-viewer>` takes in a component of Svelte. */
export type RtViewerProps = Omit<HTMLAttributes<RtViewerElement>, keyof RtViewerListeners> &
  RtViewerAttributes &
  RtViewerProperties &
  RtViewerListeners;

declare module "svelte/elements" {
  interface SvelteHTMLElements {
    "rt-viewer": RtViewerProps;
  }
}
