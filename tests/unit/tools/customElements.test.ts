import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { Ajv } from "ajv";
import type { CustomElementDeclaration, Package } from "custom-elements-manifest";
import { beforeAll, expect, test } from "vitest";
import { OBSERVED_ATTRIBUTES } from "../../../src/element/attributes";
import type { RtViewerEventMap } from "../../../src/element/events";
import { RtViewerElement } from "../../../src/element/rtViewerElement";
import { createCustomElementsManifest } from "../../../tools/customElements";

const SOURCES = new URL("../../../src/element/", import.meta.url);

let manifest: Package;
let element: CustomElementDeclaration;
beforeAll(async () => {
  manifest = await createCustomElementsManifest();
  element = manifest.modules[0]!.declarations![0] as CustomElementDeclaration;
});

test("the manifest is one, by the schema of manifests", () => {
  const path = createRequire(import.meta.url).resolve("custom-elements-manifest/schema.json");
  const validate = new Ajv({ strict: false }).compile(JSON.parse(readFileSync(path, "utf8")));
  expect(validate(manifest), JSON.stringify(validate.errors)).toBe(true);
});

test("every observed attribute is in it, with its property", () => {
  expect(namesOf(element.attributes)).toEqual([...OBSERVED_ATTRIBUTES].sort());
  expect(element.attributes).toContainEqual({
    name: "target-error",
    fieldName: "targetError",
    type: { text: "number" },
    description: "Sampling stops at this relative RMSE (0.01 is 1 %). Attribute `target-error`, default 0: never.",
    default: "0",
  });
});

test("every public property and method is in it", () => {
  const inherited = Object.getPrototypeOf(RtViewerElement);
  const names = [RtViewerElement, inherited].flatMap(({ prototype }) => Object.getOwnPropertyNames(prototype));
  // What only the browser or the element itself calls.
  const hidden = /^(constructor|\w+Callback|settingsChanged|upgradeProperties)$/;
  expect(namesOf(element.members)).toEqual(names.filter((name) => !hidden.test(name)).sort());
});

test("a property without a setter is read-only", () => {
  const readOnly = element.members?.filter((member) => member.kind === "field" && member.readonly);
  expect(namesOf(readOnly)).toEqual(expect.arrayContaining(["tracer", "variants"]));
  expect(namesOf(readOnly)).not.toContain("scene");
});

test("every event is in it", () => {
  const events: Record<keyof RtViewerEventMap, true> = {
    ready: true,
    progress: true,
    converged: true,
    error: true,
    devicelost: true,
    loadprogress: true,
    loadwarnings: true,
    pick: true,
  };
  expect(namesOf(element.events)).toEqual(Object.keys(events).sort());
  expect(element.events).toContainEqual({
    name: "progress",
    type: { text: "CustomEvent<ProgressDetail>" },
    description: "More samples are in the picture. At most ten times a second.",
  });
});

test("every slot, part and custom property in the element's source is in it", () => {
  const source = readdirSync(SOURCES).map((name) => readFileSync(new URL(name, SOURCES), "utf8"));
  const code = source.join("\n").replaceAll(/\/\*\*.*?\*\//gs, "");
  const found = (pattern: RegExp) => [...new Set([...code.matchAll(pattern)].map(([, name]) => name))].sort();
  expect(namesOf(element.cssParts)).toEqual(found(/"part", "([\w-]+)"/g));
  expect(namesOf(element.cssProperties)).toEqual(found(/(--rt-viewer-[\w-]+)/g));
  const slotCount = [...code.matchAll(/<slot|createElement\("slot"\)/g)].length;
  expect(element.slots).toHaveLength(slotCount);
});

test("everything in it is described", () => {
  const { attributes = [], members = [], events = [], cssParts = [], cssProperties = [], slots = [] } = element;
  const all = [...attributes, ...members, ...events, ...cssParts, ...cssProperties, ...slots];
  expect(all.filter(({ description }) => !description).map(({ name }) => name)).toEqual([]);
});

function namesOf(items: readonly { readonly name: string }[] = []): string[] {
  return items.map(({ name }) => name).sort();
}
