import { DEFAULT_SETTINGS, type Settings } from "../renderer/settings";
import type { ToneMap } from "../renderer/view";
import type { Reflection } from "./attributeKinds";
import { ATTRIBUTES, type LoadingMode, SETTING_ATTRIBUTES, SETTING_NAMES } from "./attributes";
import type { RtViewerEventTarget } from "./events";

/** In bare Node and under server-side rendering there is no `HTMLElement`; importing must work all the same. */
const BrowserElement = (globalThis.HTMLElement ?? class {}) as new () => RtViewerEventTarget;

/** The attributes of `<rt-viewer>` as properties. What they do is the business of the class that extends this one. */
export class ReflectedElement extends BrowserElement {
  /** For the settings that have no attribute. */
  #settings: Partial<Settings> = {};

  /** URL of a scene file, JSON or glTF, relative to the page. Attribute `src`. Overridden by the property `scene`. */
  get src(): string {
    return ATTRIBUTES.src.read(this);
  }
  set src(value: string) {
    ATTRIBUTES.src.write(this, value);
  }

  /**
   * Which of the glTF file's `variants` is shown. Attribute `variant-name`, default `null`: the materials that the file has without
   * any, which also stand in for a variant that it does not have. The camera stays when it changes.
   */
  get variantName(): string | null {
    return ATTRIBUTES.variantName.read(this);
  }
  set variantName(value: string | null) {
    ATTRIBUTES.variantName.write(this, value);
  }

  /** Whether pointer, wheel and keyboard move the camera. Attribute `controls`, default off. */
  get controls(): boolean {
    return ATTRIBUTES.controls.read(this);
  }
  set controls(value: boolean) {
    ATTRIBUTES.controls.write(this, value);
  }

  /** Whether a file that is dropped on the element is shown: a scene, with the files it refers to. Attribute `drop`, default off. */
  get drop(): boolean {
    return ATTRIBUTES.drop.read(this);
  }
  set drop(value: boolean) {
    ATTRIBUTES.drop.write(this, value);
  }

  /**
   * Whether the panel with figures and knobs is shown. Attribute `stats`, default off. `stats="folded"` starts with its
   * title only, as a small element always does.
   */
  get showStats(): boolean {
    return ATTRIBUTES.showStats.read(this);
  }
  set showStats(value: boolean) {
    ATTRIBUTES.showStats.write(this, value);
  }

  /** Whether the picture rests as it is, once a view has its first sample. Attribute `paused`, default off. */
  get paused(): boolean {
    return ATTRIBUTES.paused.read(this);
  }
  set paused(value: boolean) {
    ATTRIBUTES.paused.write(this, value);
  }

  /** What the picture shows, for those who do not see it. Attribute `alt`, default "". */
  get alt(): string {
    return ATTRIBUTES.alt.read(this);
  }
  set alt(value: string) {
    ATTRIBUTES.alt.write(this, value);
  }

  /** URL of an image that is shown until there is a picture. Attribute `poster`, default "". The slot `poster` overrides it. */
  get poster(): string {
    return ATTRIBUTES.poster.read(this);
  }
  set poster(value: string) {
    ATTRIBUTES.poster.write(this, value);
  }

  /**
   * `"lazy"` fetches and compiles nothing before the element is less than a screen away from what is seen of the page.
   * Attribute `loading`, default `"eager"`.
   */
  get loading(): LoadingMode {
    return ATTRIBUTES.loading.read(this);
  }
  set loading(value: LoadingMode) {
    ATTRIBUTES.loading.write(this, value);
  }

  /**
   * Where the picture is seen from, around the target of the scene's camera: azimuth, elevation and distance, such as
   * `"30deg 15deg 5m"`. Attribute `camera-orbit`, default "": as the scene has it. Units: `deg`, `rad`; `m`, `cm`, `mm`;
   * `auto` in place of a part leaves it as the scene has it. Setting it moves the camera; where a visitor moves the camera
   * is in `camera`, not here.
   */
  get cameraOrbit(): string {
    return ATTRIBUTES.cameraOrbit.read(this);
  }
  set cameraOrbit(value: string) {
    ATTRIBUTES.cameraOrbit.write(this, value);
  }

  /** How radiance is brought into a display's range: `"none"`, `"aces"` or `"agx"`. Attribute `tone-map`, default `"aces"`. */
  get toneMap(): ToneMap {
    return ATTRIBUTES.toneMap.read(this);
  }
  set toneMap(value: ToneMap) {
    ATTRIBUTES.toneMap.write(this, value);
  }

  /** Brightness of the picture in stops: +1 doubles it. Attribute `exposure`, −32…32, default 0. */
  get exposure(): number {
    return ATTRIBUTES.exposure.read(this);
  }
  set exposure(value: number) {
    ATTRIBUTES.exposure.write(this, value);
  }

  /** How often a path may scatter. Attribute `max-bounces`, an integer ≥ 0; default `undefined`: what the scene says. */
  get maxBounces(): number | undefined {
    return ATTRIBUTES.maxBounces.read(this);
  }
  set maxBounces(value: number | undefined) {
    ATTRIBUTES.maxBounces.write(this, value);
  }

  /**
   * Samples per pixel between two frames, as far as the frame budget allows. Attribute `samples-per-frame`, default `"auto"`: as
   * many as it allows.
   */
  get samplesPerFrame(): number | "auto" {
    return ATTRIBUTES.samplesPerFrame.read(this);
  }
  set samplesPerFrame(value: number | "auto") {
    ATTRIBUTES.samplesPerFrame.write(this, value);
  }

  /** Light points sampled at each hit. Attribute `light-samples`, an integer ≥ 1, default 1. */
  get lightSamples(): number {
    return ATTRIBUTES.lightSamples.read(this);
  }
  set lightSamples(value: number) {
    ATTRIBUTES.lightSamples.write(this, value);
  }

  /** Sampling stops at this relative RMSE (0.01 is 1 %). Attribute `target-error`, default 0: never. */
  get targetError(): number {
    return ATTRIBUTES.targetError.read(this);
  }
  set targetError(value: number) {
    ATTRIBUTES.targetError.write(this, value);
  }

  /** Sampling stops after this many samples per pixel. Attribute `max-samples`, default `Infinity`. */
  get maxSamples(): number {
    return ATTRIBUTES.maxSamples.read(this);
  }
  set maxSamples(value: number) {
    ATTRIBUTES.maxSamples.write(this, value);
  }

  /**
   * How the scene is sampled, all settings together. Setting it changes the ones it names: those with an attribute
   * through the attribute.
   */
  get settings(): Settings {
    const settings: Record<string, unknown> = { ...DEFAULT_SETTINGS, ...this.#settings };
    for (const name of SETTING_NAMES) settings[name] = SETTING_ATTRIBUTES[name].read(this);
    return settings as Settings;
  }
  set settings(changes: Partial<Settings>) {
    this.#settings = { ...this.#settings, ...changes };
    for (const name of SETTING_NAMES) {
      const attribute: Reflection<Settings[typeof name]> = SETTING_ATTRIBUTES[name];
      if (name in changes) attribute.write(this, changes[name]);
    }
    this.settingsChanged();
  }

  /** Called after `settings` was set. */
  protected settingsChanged(): void {}

  /** Honours properties that were set before the element was defined: they hide the accessors until set again. */
  protected upgradeProperties(): void {
    for (const name of Object.keys(this)) {
      if (!(name in Object.getPrototypeOf(this))) continue;
      const value: unknown = Reflect.get(this, name);
      Reflect.deleteProperty(this, name);
      Reflect.set(this, name, value);
    }
  }
}
