import { DEFAULT_SETTINGS, type Settings } from "../renderer/settings";
import { TONE_MAPS, type ToneMap } from "../renderer/view";
import {
  EXPOSURE_RULE,
  LOADING_MODES,
  type LoadingMode,
  parseKeyword,
  parseNumber,
  SETTING_ATTRIBUTES,
  SETTING_NAMES,
  type SettingName,
} from "./attributes";
import type { RtViewerEventTarget } from "./events";

/** In bare Node and under server-side rendering there is no `HTMLElement`; importing must work all the same. */
const BrowserElement = (globalThis.HTMLElement ?? class {}) as new () => RtViewerEventTarget;

/** The attributes of `<rt-viewer>` as properties. What they do is the business of the class that extends this one. */
export class ReflectedElement extends BrowserElement {
  /** For the settings that have no attribute. */
  #settings: Partial<Settings> = {};

  /** URL of a scene file, JSON or glTF, relative to the page. Attribute `src`. Overridden by the property `scene`. */
  get src(): string {
    return this.getAttribute("src") ?? "";
  }
  set src(value: string) {
    this.setAttribute("src", value);
  }

  /** Whether pointer, wheel and keyboard move the camera. Attribute `controls`, default off. */
  get controls(): boolean {
    return this.hasAttribute("controls");
  }
  set controls(value: boolean) {
    this.toggleAttribute("controls", Boolean(value));
  }

  /** Whether a file that is dropped on the element is shown: a scene, with the files it refers to. Attribute `drop`, default off. */
  get drop(): boolean {
    return this.hasAttribute("drop");
  }
  set drop(value: boolean) {
    this.toggleAttribute("drop", Boolean(value));
  }

  /**
   * Whether the panel with figures and knobs is shown. Attribute `stats`, default off. `stats="folded"` starts with its
   * title only, as a small element always does.
   */
  get showStats(): boolean {
    return this.hasAttribute("stats");
  }
  set showStats(value: boolean) {
    this.toggleAttribute("stats", Boolean(value));
  }

  /** Whether the picture rests as it is, once a view has its first sample. Attribute `paused`, default off. */
  get paused(): boolean {
    return this.hasAttribute("paused");
  }
  set paused(value: boolean) {
    this.toggleAttribute("paused", Boolean(value));
  }

  /** What the picture shows, for those who do not see it. Attribute `alt`, default "". */
  get alt(): string {
    return this.getAttribute("alt") ?? "";
  }
  set alt(value: string) {
    this.setAttribute("alt", value);
  }

  /** URL of an image that is shown until there is a picture. Attribute `poster`, default "". The slot `poster` overrides it. */
  get poster(): string {
    return this.getAttribute("poster") ?? "";
  }
  set poster(value: string) {
    this.setAttribute("poster", value);
  }

  /**
   * `"lazy"` fetches and compiles nothing before the element is less than a screen away from what is seen of the page.
   * Attribute `loading`, default `"eager"`.
   */
  get loading(): LoadingMode {
    return parseKeyword(this.getAttribute("loading"), LOADING_MODES, "eager");
  }
  set loading(value: LoadingMode) {
    this.setAttribute("loading", value);
  }

  /**
   * Where the picture is seen from, around the target of the scene's camera: azimuth, elevation and distance, such as
   * `"30deg 15deg 5m"`. Attribute `camera-orbit`, default "": as the scene has it. Units: `deg`, `rad`; `m`, `cm`, `mm`;
   * `auto` in place of a part leaves it as the scene has it. Setting it moves the camera; where a visitor moves the camera
   * is in `camera`, not here.
   */
  get cameraOrbit(): string {
    return this.getAttribute("camera-orbit") ?? "";
  }
  set cameraOrbit(value: string) {
    this.setAttribute("camera-orbit", value);
  }

  /** How radiance is brought into a display's range: `"none"`, `"aces"` or `"agx"`. Attribute `tone-map`, default `"aces"`. */
  get toneMap(): ToneMap {
    return parseKeyword(this.getAttribute("tone-map"), TONE_MAPS, "aces");
  }
  set toneMap(value: ToneMap) {
    this.setAttribute("tone-map", value);
  }

  /** Brightness of the picture in stops: +1 doubles it. Attribute `exposure`, −32…32, default 0. */
  get exposure(): number {
    return parseNumber(this.getAttribute("exposure"), EXPOSURE_RULE) ?? 0;
  }
  set exposure(value: number) {
    this.setAttribute("exposure", String(value));
  }

  /** How often a path may scatter. Attribute `max-bounces`, an integer ≥ 0; default `undefined`: what the scene says. */
  get maxBounces(): number | undefined {
    return this.#number("maxBounces");
  }
  set maxBounces(value: number | undefined) {
    this.#reflect("maxBounces", value);
  }

  /**
   * Samples per pixel between two frames, as far as the frame budget allows. Attribute `samples-per-frame`, default `"auto"`: as
   * many as it allows.
   */
  get samplesPerFrame(): number | "auto" {
    return this.#number("samplesPerFrame") ?? DEFAULT_SETTINGS.samplesPerFrame;
  }
  set samplesPerFrame(value: number | "auto") {
    this.#reflect("samplesPerFrame", value);
  }

  /** Light points sampled at each hit. Attribute `light-samples`, an integer ≥ 1, default 1. */
  get lightSamples(): number {
    return this.#number("lightSamples") ?? DEFAULT_SETTINGS.lightSamples;
  }
  set lightSamples(value: number) {
    this.#reflect("lightSamples", value);
  }

  /** Sampling stops at this relative RMSE (0.01 is 1 %). Attribute `target-error`, default 0: never. */
  get targetError(): number {
    return this.#number("targetError") ?? DEFAULT_SETTINGS.targetError;
  }
  set targetError(value: number) {
    this.#reflect("targetError", value);
  }

  /** Sampling stops after this many samples per pixel. Attribute `max-samples`, default `Infinity`. */
  get maxSamples(): number {
    return this.#number("maxSamples") ?? DEFAULT_SETTINGS.maxSamples;
  }
  set maxSamples(value: number) {
    this.#reflect("maxSamples", value);
  }

  /**
   * How the scene is sampled, all settings together. Setting it changes the ones it names: those with an attribute
   * through the attribute.
   */
  get settings(): Settings {
    const settings: Record<string, unknown> = { ...DEFAULT_SETTINGS, ...this.#settings };
    for (const name of SETTING_NAMES) settings[name] = this.#number(name) ?? DEFAULT_SETTINGS[name];
    return settings as Settings;
  }
  set settings(changes: Partial<Settings>) {
    this.#settings = { ...this.#settings, ...changes };
    for (const name of SETTING_NAMES) if (name in changes) this.#reflect(name, changes[name]);
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

  #number(name: SettingName): number | undefined {
    const rule = SETTING_ATTRIBUTES[name];
    return parseNumber(this.getAttribute(rule.attribute), rule);
  }

  #reflect(name: SettingName, value: number | "auto" | undefined): void {
    const { attribute } = SETTING_ATTRIBUTES[name];
    if (value === undefined || value === null) this.removeAttribute(attribute);
    else this.setAttribute(attribute, String(value));
  }
}
