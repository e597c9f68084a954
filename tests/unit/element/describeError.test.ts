import { describe, expect, it } from "vitest";
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

describe("missingWebGpu", () => {
  it("has nothing to say where there is WebGPU", () => {
    expect(missingWebGpu({ hasGpu: true, isSecure: true })).toBeUndefined();
  });

  it("tells an insecure page from an old browser", () => {
    expect(missingWebGpu({ hasGpu: false, isSecure: false })).toMatch(/https/);
    expect(missingWebGpu({ hasGpu: false, isSecure: true })).toMatch(/browser/);
  });
});
