import { type NumberRange, SETTING_RANGES } from "../renderer/checkSettings";
import { DEFAULT_SETTINGS } from "../renderer/settings";
import { TONE_MAPS } from "../renderer/view";
import { flag, keyword, number, numberOr, type Reflection, text, textOrNull } from "./attributeKinds";
import type { BoundOnDemand } from "./boundOnDemand";
import { parseCameraOrbit } from "./cameraOrbit";
import type { Face } from "./face";
import type { LazyPanel } from "./lazyPanel";
import type { ReflectedElement } from "./reflectedElement";
import type { SceneLoader } from "./sceneLoader";
import type { Stage } from "./stage";

/** What an element consists of, as far as attributes are about it. */
export type ViewerParts = {
  readonly face: Face;
  readonly stage: Stage;
  readonly scenes: SceneLoader;
  readonly panel: LazyPanel;
  readonly controls: BoundOnDemand;
  readonly drop: BoundOnDemand;
};

/** An attribute: how it is read and written, and what its change does. */
type Attribute<Value> = Reflection<Value> & {
  readonly apply: (parts: ViewerParts, viewer: ReflectedElement) => void;
};

/** Stops; 2^±32 is more than any display or scene spans, and keeps the product finite. */
export const EXPOSURE_RULE: NumberRange = { min: -32, max: 32, isInteger: false };

/** When the scene is fetched: at once, or when the element is less than a screen away from what is seen of the page. */
export const LOADING_MODES = ["eager", "lazy"] as const;

export type LoadingMode = (typeof LOADING_MODES)[number];

const applyLook: Attribute<unknown>["apply"] = ({ stage }, { exposure, toneMap }) => {
  stage.look = { exposure, toneMap };
};

/** The attributes that are settings of the tracer. */
export const SETTING_ATTRIBUTES = {
  maxBounces: setting("maxBounces", "max-bounces"),
  samplesPerFrame: setting("samplesPerFrame", "samples-per-frame"),
  lightSamples: setting("lightSamples", "light-samples"),
  targetError: setting("targetError", "target-error"),
  maxSamples: setting("maxSamples", "max-samples"),
};

/** A setting that has an attribute. */
export type SettingName = keyof typeof SETTING_ATTRIBUTES;

export const SETTING_NAMES = Object.keys(SETTING_ATTRIBUTES) as readonly SettingName[];

/** Every attribute the element reacts to, by its property. */
export const ATTRIBUTES = {
  src: { ...text("src"), apply: ({ scenes }) => scenes.noteSrc() },
  variantName: { ...textOrNull("variant-name"), apply: ({ scenes }) => scenes.noteVariant() },
  controls: {
    ...flag("controls"),
    apply({ face, controls }, viewer) {
      controls.rebind();
      face.describe(viewer.alt, viewer.controls);
    },
  },
  drop: { ...flag("drop"), apply: ({ drop }) => drop.rebind() },
  showStats: { ...flag("stats"), apply: ({ panel }) => panel.show() },
  paused: {
    ...flag("paused"),
    apply({ stage }, { paused }) {
      stage.isPaused = paused;
    },
  },
  alt: { ...text("alt"), apply: ({ face }, { alt, controls }) => face.describe(alt, controls) },
  poster: { ...text("poster"), apply: ({ face }, { poster, loading }) => face.setPoster(poster, loading) },
  loading: {
    ...keyword("loading", LOADING_MODES, "eager"),
    apply({ face, scenes }, { poster, loading }) {
      scenes.noteLoading();
      face.setPoster(poster, loading);
    },
  },
  exposure: { ...number("exposure", EXPOSURE_RULE, 0), apply: applyLook },
  toneMap: { ...keyword("tone-map", TONE_MAPS, "aces"), apply: applyLook },
  cameraOrbit: {
    ...text("camera-orbit"),
    apply({ stage }, { cameraOrbit }) {
      stage.orbit = parseCameraOrbit(cameraOrbit);
    },
  },
  ...SETTING_ATTRIBUTES,
} satisfies { readonly [property: string]: Attribute<unknown> };

const all: readonly Attribute<unknown>[] = Object.values(ATTRIBUTES);

export const OBSERVED_ATTRIBUTES: readonly string[] = all.map(({ attribute }) => attribute);

/** Does what a changed attribute is there for. */
export function applyAttribute(name: string, parts: ViewerParts, viewer: ReflectedElement): void {
  all.find(({ attribute }) => attribute === name)?.apply(parts, viewer);
}

function setting<Name extends keyof typeof SETTING_RANGES>(name: Name, attribute: string) {
  const apply: Attribute<unknown>["apply"] = ({ stage }, { settings }) => {
    stage.settings = settings;
  };
  return { ...numberOr(attribute, SETTING_RANGES[name], DEFAULT_SETTINGS[name]), apply };
}
