import { expect, it } from "vitest";
import { parseKeyword, parseNumber, type Reflection } from "../../../src/element/attributeKinds";
import {
  ATTRIBUTES,
  applyAttribute,
  EXPOSURE_RULE,
  LOADING_MODES,
  OBSERVED_ATTRIBUTES,
  SETTING_ATTRIBUTES,
  type ViewerParts,
} from "../../../src/element/attributes";
import { ReflectedElement } from "../../../src/element/reflectedElement";
import { RtViewerElement } from "../../../src/element/rtViewerElement";
import { SETTING_RANGES } from "../../../src/renderer/checkSettings";

it.each([
  ["4", 4],
  [" 16 ", 16],
  ["1e2", 100],
  ["0", undefined],
  ["-3", undefined],
  ["2.5", undefined],
  ["many", undefined],
  ["", undefined],
  ["NaN", undefined],
  ["Infinity", undefined],
  [null, undefined],
])("samples-per-frame=%j counts as %j", (text, wanted) => {
  expect(parseNumber(text, SETTING_RANGES.samplesPerFrame)).toBe(wanted);
});

it("max-samples may be infinite", () => {
  expect(parseNumber("Infinity", SETTING_RANGES.maxSamples)).toBe(Number.POSITIVE_INFINITY);
});

it("exposure is any number of stops that keeps its power of two finite", () => {
  expect(parseNumber("-1.5", EXPOSURE_RULE)).toBe(-1.5);
  expect(parseNumber("1000", EXPOSURE_RULE)).toBeUndefined();
});

it.each([
  ["lazy", "lazy"],
  [" LAZY ", "lazy"],
  ["eager", "eager"],
  ["", "eager"],
  ["later", "eager"],
  [null, "eager"],
])("loading=%j counts as %j", (text, wanted) => {
  expect(parseKeyword(text, LOADING_MODES, "eager")).toBe(wanted);
});

/** As much of an element as attributes are. */
function bareElement() {
  const attributes = new Map<string, string>();
  const element = {
    getAttribute: (name: string) => attributes.get(name) ?? null,
    hasAttribute: (name: string) => attributes.has(name),
    setAttribute: (name: string, value: unknown) => void attributes.set(name, String(value)),
    removeAttribute: (name: string) => void attributes.delete(name),
    toggleAttribute(name: string, isThere: boolean) {
      if (!isThere) attributes.delete(name);
      else if (!attributes.has(name)) attributes.set(name, "");
      return isThere;
    },
  };
  return element as unknown as Element;
}

/** Takes note of what is set, as `part.property=`, and called, as `part.method()`. */
function recordingParts(record: string[]): ViewerParts {
  const part = (name: string) =>
    new Proxy(
      {},
      {
        get: (_, method) => () => record.push(`${name}.${String(method)}()`),
        set: (_, property) => record.push(`${name}.${String(property)}=`) > 0,
      },
    );
  return new Proxy({} as ViewerParts, { get: (_, name) => part(String(name)) });
}

it("every attribute is observed, once, and has a property that is read and written", () => {
  expect(RtViewerElement.observedAttributes).toBe(OBSERVED_ATTRIBUTES);
  expect(new Set(OBSERVED_ATTRIBUTES).size).toBe(OBSERVED_ATTRIBUTES.length);
  const properties = Object.getOwnPropertyDescriptors(ReflectedElement.prototype);
  for (const name of Object.keys(ATTRIBUTES)) {
    expect(properties, name).toHaveProperty(name, expect.objectContaining({ get: expect.any(Function) }));
    expect(properties, name).toHaveProperty(name, expect.objectContaining({ set: expect.any(Function) }));
  }
});

it("every accessor of the element but `settings` has an attribute", () => {
  const accessors = Object.entries(Object.getOwnPropertyDescriptors(ReflectedElement.prototype)).filter(
    ([, { get }]) => get !== undefined,
  );
  expect(accessors.map(([name]) => name).sort()).toEqual([...Object.keys(ATTRIBUTES), "settings"].sort());
});

it.each([
  ["src", ["scenes.noteSrc()"]],
  ["variant-name", ["scenes.noteVariant()"]],
  ["controls", ["controls.rebind()", "face.describe()"]],
  ["drop", ["drop.rebind()"]],
  ["stats", ["panel.show()"]],
  ["paused", ["stage.isPaused="]],
  ["alt", ["face.describe()"]],
  ["poster", ["face.setPoster()"]],
  ["loading", ["scenes.noteLoading()", "face.setPoster()"]],
  ["exposure", ["stage.look="]],
  ["tone-map", ["stage.look="]],
  ["camera-orbit", ["stage.orbit="]],
  ["max-bounces", ["stage.settings="]],
  ["samples-per-frame", ["stage.settings="]],
  ["light-samples", ["stage.settings="]],
  ["target-error", ["stage.settings="]],
  ["max-samples", ["stage.settings="]],
  ["class", []],
])("a change of %s is for %j", (name, wanted) => {
  const record: string[] = [];
  applyAttribute(name, recordingParts(record), {} as ReflectedElement);
  expect(record).toEqual(wanted);
});

it("every attribute does something", () => {
  for (const name of OBSERVED_ATTRIBUTES) {
    const record: string[] = [];
    applyAttribute(name, recordingParts(record), {} as ReflectedElement);
    expect(record, name).not.toEqual([]);
  }
});

it.each(Object.entries(ATTRIBUTES) as [string, Reflection<unknown>][])(
  "%s: whatever is written, what is read of it can be written and is read again",
  (_, reflection) => {
    const element = bareElement();
    const whenAbsent = reflection.read(element);
    for (const value of [whenAbsent, 1.5, "", true, "nonsense"]) {
      reflection.write(element, value);
      const read = reflection.read(element);
      reflection.write(element, read);
      expect(reflection.read(element)).toBe(read);
    }
  },
);

it("a flag that is there keeps its text when it is set again", () => {
  const element = bareElement();
  element.setAttribute("stats", "folded");
  ATTRIBUTES.showStats.write(element, true);
  expect(element.getAttribute("stats")).toBe("folded");
  ATTRIBUTES.showStats.write(element, false);
  expect(element.hasAttribute("stats")).toBe(false);
});

it.each([null, undefined])("a name that is set to %j loses its attribute, and is null", (nothing) => {
  const element = bareElement();
  ATTRIBUTES.variantName.write(element, "Night");
  expect(ATTRIBUTES.variantName.read(element)).toBe("Night");
  ATTRIBUTES.variantName.write(element, nothing as null);
  expect(element.hasAttribute("variant-name")).toBe(false);
  expect(ATTRIBUTES.variantName.read(element)).toBeNull();
});

it("a setting that is set to undefined loses its attribute, and has its default", () => {
  const element = bareElement();
  SETTING_ATTRIBUTES.maxBounces.write(element, 3);
  expect(element.getAttribute("max-bounces")).toBe("3");
  SETTING_ATTRIBUTES.maxBounces.write(element, undefined);
  expect(element.hasAttribute("max-bounces")).toBe(false);
  expect(SETTING_ATTRIBUTES.maxBounces.read(element)).toBeUndefined();
});
