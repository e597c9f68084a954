// Defines <rt-viewer>, and tells Vue's templates what it takes: @ready, @converged, :scene, …

import "../element";
import type { HTMLAttributes, PublicProps } from "vue";
import type { RtViewerEventMap } from "../element/events";
import type { RtViewerElement } from "../element/rtViewerElement";
import type { RtViewerAttributes, RtViewerProperties } from "./attributes";

export type { RtViewerAttributes, RtViewerProperties };

type Listeners = {
  readonly [Name in keyof RtViewerEventMap as `on${Capitalize<Name>}`]?: (event: RtViewerEventMap[Name]) => void;
};

/** What `<rt-viewer>` takes in a template of Vue. */
export type RtViewerProps = PublicProps &
  Omit<HTMLAttributes, keyof Listeners> &
  RtViewerAttributes &
  RtViewerProperties &
  Listeners;

/** The element as Vue's templates see it. */
export type RtViewerComponent = new () => RtViewerElement & { readonly $props: RtViewerProps };

declare module "vue" {
  interface GlobalComponents {
    "rt-viewer": RtViewerComponent;
  }
}
