import type * as manifest from "custom-elements-manifest";
import { OBSERVED_ATTRIBUTES } from "../src/element/attributes";
import type { Docstring } from "./docstrings";
import { type Member, readClass, readEvents } from "./elementSource";

const TAG = "rt-viewer";
const CLASS = "RtViewerElement";
const MODULE = "dist/element.js";

/**
 * The custom elements manifest, for editors, Storybook and the like: made from the source of the element and its docstrings.
 * A property's docstring names the attribute it reflects (Attribute `max-bounces`, default 8); `@slot`, `@csspart` and
 * `@cssprop` stand in the docstring of the class.
 *
 * @throws {TypeError} if an observed attribute is in no docstring.
 */
export async function createCustomElementsManifest(): Promise<manifest.Package> {
  const source = (name: string) => new URL(`../src/element/${name}.ts`, import.meta.url);
  const { members, docs } = await readClass(source("rtViewerElement"), CLASS);
  const events = await readEvents(source("events"), "RtViewerEventMap");

  const declaration: manifest.CustomElementDeclaration = {
    kind: "class",
    name: CLASS,
    tagName: TAG,
    customElement: true,
    description: docs.at(-1)?.text ?? "",
    superclass: { name: "HTMLElement" },
    attributes: OBSERVED_ATTRIBUTES.map((name) => describeAttribute(name, members)),
    members: members.map(describeMember),
    events: events.map(({ name, type, description }) => ({ name, type: { text: type }, description })),
    slots: tagsOf(docs, "slot"),
    cssParts: tagsOf(docs, "csspart"),
    cssProperties: tagsOf(docs, "cssprop"),
  };
  const reference = { name: CLASS, module: MODULE };
  const exports: manifest.Export[] = [
    { kind: "js", name: CLASS, declaration: reference },
    { kind: "custom-element-definition", name: TAG, declaration: reference },
  ];
  return {
    schemaVersion: "2.1.0",
    modules: [{ kind: "javascript-module", path: MODULE, declarations: [declaration], exports }],
  };
}

function describeAttribute(name: string, members: readonly Member[]): manifest.Attribute {
  const member = members.find(({ docs }) => attributeIn(docs) === name);
  if (member === undefined) throw new TypeError(`No property's docstring says: Attribute \`${name}\`.`);
  const { description, default: value } = describeMember(member) as manifest.CustomElementField;
  return {
    name,
    fieldName: member.name,
    type: { text: member.type },
    ...(description === undefined ? {} : { description }),
    ...(value === undefined ? {} : { default: value }),
  };
}

function describeMember({ kind, name, type, isReadOnly, docs }: Member): manifest.ClassMember {
  const description = docs === undefined ? {} : { description: docs.text };
  if (kind === "method") return { kind, name, return: { type: { text: type } }, ...description };
  const attribute = attributeIn(docs);
  const value = defaultIn(docs);
  return {
    kind,
    name,
    type: { text: type },
    ...description,
    ...(value === undefined ? {} : { default: value }),
    ...(attribute === undefined ? {} : { attribute, reflects: true }),
    ...(isReadOnly ? { readonly: true } : {}),
  };
}

function attributeIn(docs: Docstring | undefined): string | undefined {
  return /Attribute `([\w-]+)`/.exec(docs?.text ?? "")?.[1];
}

function defaultIn(docs: Docstring | undefined): string | undefined {
  const value = /default `?([^`.:;]+)/.exec(docs?.text ?? "")?.[1];
  return value === "off" ? "false" : value;
}

/** `@slot name - description`; the name may be left out. */
function tagsOf(docs: readonly Docstring[], tag: string): { name: string; description: string }[] {
  return docs.flatMap(({ tags }) =>
    tags
      .filter(({ name }) => name === tag)
      .map(({ text }) => {
        const [name = "", ...description] = text.split(/(?:^| )- /);
        return { name, description: description.join("- ") };
      }),
  );
}
