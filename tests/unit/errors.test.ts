import { expect, test } from "vitest";
import { LoadError, RtViewerError, SceneError, UnsupportedError, WebGpuError } from "../../src/errors";

test("every error is an RtViewerError and says its own name", () => {
  const errors = [new SceneError([]), new WebGpuError("no adapter"), new UnsupportedError("mesh"), new LoadError("x")];
  for (const error of errors) expect(error).toBeInstanceOf(RtViewerError);
  expect(errors.map((error) => error.name)).toEqual(["SceneError", "WebGpuError", "UnsupportedError", "LoadError"]);
  expect(new RtViewerError("x").name).toBe("RtViewerError");
});

test("an error keeps its cause", () => {
  const cause = new Error("lost");
  expect(new WebGpuError("the device is lost", { cause }).cause).toBe(cause);
  expect(new SceneError([], { cause }).cause).toBe(cause);
});

test("the message of a SceneError lists every issue on a line of its own", () => {
  const issues = [
    { path: "", message: "expected an object, got null" },
    { path: "objects[3].radius", message: "expected a finite number > 0, got -1" },
  ];
  const error = new SceneError(issues);
  expect(error.issues).toEqual(issues);
  expect(error.message).toBe(
    "The scene has 2 errors:\nscene: expected an object, got null\nobjects[3].radius: expected a finite number > 0, got -1",
  );
});

test("one issue is one error", () => {
  expect(new SceneError([{ path: "camera", message: "x" }]).message).toBe("The scene has 1 error:\ncamera: x");
});

test("a SceneError of a hundred thousand issues holds a hundred, and counts", () => {
  const issues = Array.from({ length: 98_865 }, (_, i) => ({ path: `k${i}`, message: "unknown key" }));
  const error = new SceneError(issues);
  expect(error.issues).toEqual(issues.slice(0, 100));
  expect(error.issueCount).toBe(98_865);
  const lines = error.message.split("\n");
  expect(lines).toHaveLength(102);
  expect(lines[0]).toBe("The scene has 98,865 errors:");
  expect(lines.at(-1)).toBe("… and 98,765 more");
});
