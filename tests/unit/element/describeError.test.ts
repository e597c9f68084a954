import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { describeError, missingWebGpu } from "../../../src/element/describeError";
import { RtViewerError, SceneError, UnsupportedError, WebGpuError } from "../../../src/errors";

describe("describeError", () => {
  it("lists every issue of a scene on its own line", () => {
    const error = new SceneError([
      { path: "objects[3].radius", message: "expected a finite number > 0, got -1" },
      { path: "", message: "expected an object" },
    ]);
    expect(describeError(error)).toEqual({
      title: "The scene has 2 mistakes",
      lines: ["objects[3].radius: expected a finite number > 0, got -1", "scene: expected an object"],
      isCode: true,
    });
  });

  it("lists twenty of a hundred thousand issues, and counts the rest", () => {
    const issues = Array.from({ length: 30 }, (_, i) => ({ path: `k${i}`, message: "unknown key" }));
    const { title, lines } = describeError(new SceneError(issues, { issueCount: 100_000 }));
    expect(title).toBe("The scene has 100,000 mistakes");
    expect(lines).toHaveLength(21);
    expect(lines[19]).toBe("k19: unknown key");
    expect(lines[20]).toBe("… and 99,980 more");
  });

  it.each([
    new UnsupportedError("no meshes yet"),
    new WebGpuError("no adapter"),
    new RtViewerError("x.json could not be fetched: 404 Not Found"),
    new TypeError("a bug"),
  ])("passes on what $name says", (error) => {
    const { title, lines } = describeError(error);
    expect(title).not.toBe("");
    expect(lines).toEqual([error.message]);
  });
});

describe("a device out of memory", () => {
  class GPUOutOfMemoryError {}
  beforeEach(() => vi.stubGlobal("GPUOutOfMemoryError", GPUOutOfMemoryError));
  afterEach(() => vi.unstubAllGlobals());

  it("is told from other failures, with what may help", () => {
    const error = new WebGpuError("not enough memory left", { cause: new GPUOutOfMemoryError() });
    const { title, lines } = describeError(error);
    expect(title).toMatch(/out of memory/);
    expect(lines).toHaveLength(2);
    expect(lines).toContain("not enough memory left");
    expect(describeError(new WebGpuError("not valid", { cause: new Error() })).title).not.toMatch(/memory/);
  });
});

it("a device that was lost is told from one that is missing", () => {
  class GPUDeviceLostInfo {}
  vi.stubGlobal("GPUDeviceLostInfo", GPUDeviceLostInfo);
  expect(describeError(new WebGpuError("again", { cause: new GPUDeviceLostInfo() })).title).toBe("The GPU was lost");
  expect(describeError(new WebGpuError("no adapter")).title).toBe("No picture without WebGPU");
  vi.unstubAllGlobals();
});

describe("missingWebGpu", () => {
  it("has nothing to say where there is WebGPU", () => {
    expect(missingWebGpu({ hasGpu: true, isSecure: true })).toBeUndefined();
  });

  it("tells an insecure page from an old browser", () => {
    expect(missingWebGpu({ hasGpu: false, isSecure: false })).toMatch(/https/);
    expect(missingWebGpu({ hasGpu: false, isSecure: true })).toMatch(/browser/);
  });
});
