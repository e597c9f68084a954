import { expect, it } from "vitest";

it("importing the element in bare Node touches nothing and throws nothing", async () => {
  expect(globalThis).not.toHaveProperty("HTMLElement");
  expect(globalThis).not.toHaveProperty("customElements");
  const { RtViewerElement } = await import("../../../src/element");
  expect(RtViewerElement).toBeTypeOf("function");
});

it("importing the panel in bare Node throws nothing", async () => {
  const { createPanel } = await import("../../../src/panel/panel");
  expect(createPanel).toBeTypeOf("function");
});
