import type { RtViewerEventMap } from "../element/events";
import type { ReflectedElement } from "../element/reflectedElement";
import type { RtViewerElement } from "../element/rtViewerElement";
import type { Settings } from "../renderer/settings";
import type { ResolvedCamera } from "../scene/schema";

/** The properties of the element that have an attribute of the same name, in kebab-case. */
type Reflected = Exclude<keyof ReflectedElement, keyof HTMLElement | "settings" | "showStats">;

type KebabCase<Name extends string> = Name extends `${infer First}${infer Rest}`
  ? `${First extends Lowercase<First> ? First : `-${Lowercase<First>}`}${KebabCase<Rest>}`
  : Name;

/** A number may be written as text. */
type Written<Value> = number extends Value ? Value | `${number}` : Value;

/** The attributes of `<rt-viewer>` that are not those of any HTML element, as templates write them. */
export type RtViewerAttributes = {
  readonly [Name in Reflected as KebabCase<Name>]?: Written<ReflectedElement[Name]> | undefined;
} & {
  /** Whether there is a panel; `"folded"` starts it as a title bar. */
  readonly stats?: boolean | "folded" | undefined;
};

/** The properties of `<rt-viewer>`, which frameworks set where there is no attribute of the same name. */
export type RtViewerProperties = {
  readonly [Name in Exclude<Reflected, keyof RtViewerAttributes>]?: ReflectedElement[Name] | undefined;
} & {
  /** Overrides `src`. Set anew, it is shown anew: keep one object as long as nothing changes. */
  readonly scene?: RtViewerElement["scene"];
  /** What is left out stays as it is. */
  readonly camera?: Partial<ResolvedCamera>;
  /** What is left out stays as it is. */
  readonly settings?: Partial<Settings>;
};

/** The listeners of `<rt-viewer>` under the names that JSX and Svelte give them: `onready`, `onprogress`, … */
export type RtViewerListeners = {
  readonly [Name in keyof RtViewerEventMap as `on${Name}`]?: ((event: RtViewerEventMap[Name]) => void) | undefined;
};
