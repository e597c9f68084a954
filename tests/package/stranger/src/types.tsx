// Only checked, never run: what templates may and may not say. Each "@ts-expect-error" fails where there is no error.

import "rt-viewer/react";
import "rt-viewer/svelte";
import "rt-viewer/vue";
import { createElement } from "react";
import schema from "rt-viewer/scene.schema.json" with { type: "json" };
import type { SvelteHTMLElements } from "svelte/elements";
import type { GlobalComponents } from "vue";

type InSvelte = SvelteHTMLElements["rt-viewer"];
type InVue = InstanceType<GlobalComponents["rt-viewer"]>["$props"];

export const dialect: string = schema.$schema;
export const tag: HTMLElementTagNameMap["rt-viewer"] = document.createElement("rt-viewer");

export const inJsx = [
  <rt-viewer key="a" src="scene.json" onClick={() => {}} aria-busy={false} />,
  <rt-viewer key="b" onconverged={({ detail }) => detail.error.toFixed(2)} exposure="-1.5" />,
  // @ts-expect-error: not a number
  <rt-viewer key="c" max-bounces="many" />,
  // @ts-expect-error: not an attribute
  <rt-viewer key="d" maxbounces={3} />,
  // @ts-expect-error: a scene has a camera
  <rt-viewer key="e" scene={{ objects: [] }} />,
  // @ts-expect-error: "ready" has no error
  <rt-viewer key="f" onready={({ detail }) => detail.error} />,
  createElement("rt-viewer", { src: "scene.json" }),
];

export const inSvelte: InSvelte[] = [
  { src: "scene.json", controls: true, stats: "folded", class: "picture", onclick: () => {} },
  { "samples-per-frame": 4, targetError: 0.01, onready: ({ detail }) => detail.tracer.reset() },
  // @ts-expect-error: neither on, off nor folded
  { stats: "yes" },
  // @ts-expect-error: the error is an Error
  { onerror: ({ detail }) => detail.error.samples },
];

export const inVue: InVue[] = [
  { src: "scene.json", controls: true, stats: "folded", class: ["picture"], key: 1, onClick: () => {} },
  { "samples-per-frame": 4, targetError: 0.01, onReady: ({ detail }) => detail.tracer.reset() },
  // @ts-expect-error: neither on, off nor folded
  { stats: "yes" },
  // @ts-expect-error: the error is an Error
  { onError: ({ detail }) => detail.error.samples },
];
