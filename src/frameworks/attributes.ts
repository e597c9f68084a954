import type { SETTING_ATTRIBUTES, SettingName } from "../element/attributes";
import type { RtViewerEventMap } from "../element/events";
import type { RtViewerElement } from "../element/rtViewerElement";
import type { Settings } from "../renderer/settings";
import type { ResolvedCamera } from "../scene/schema";

/** The attributes of `<rt-viewer>` that are not those of any HTML element, as templates write them. */
export type RtViewerAttributes = {
  readonly [Name in SettingName as (typeof SETTING_ATTRIBUTES)[Name]["attribute"]]?: number | `${number}` | undefined;
} & {
  /** URL of a scene file, relative to the page. */
  readonly src?: string | undefined;
  readonly controls?: boolean | undefined;
  /** Whether there is a panel; `"folded"` starts it as a title bar. */
  readonly stats?: boolean | "folded" | undefined;
  readonly paused?: boolean | undefined;
  /** What the picture shows, for those who do not see it. */
  readonly alt?: string | undefined;
  /** In stops. */
  readonly exposure?: number | `${number}` | undefined;
};

/** The properties of `<rt-viewer>` that have no attribute; frameworks set them as properties. */
export type RtViewerProperties = {
  /** Overrides `src`. Set anew, it is shown anew: keep one object as long as nothing changes. */
  readonly scene?: RtViewerElement["scene"];
  /** What is left out stays as it is. */
  readonly camera?: Partial<ResolvedCamera>;
  /** What is left out stays as it is. */
  readonly settings?: Partial<Settings>;
} & { readonly [Name in SettingName]?: Settings[Name] | undefined };

/** The listeners of `<rt-viewer>` under the names that JSX and Svelte give them: `onready`, `onprogress`, … */
export type RtViewerListeners = {
  readonly [Name in keyof RtViewerEventMap as `on${Name}`]?: ((event: RtViewerEventMap[Name]) => void) | undefined;
};
