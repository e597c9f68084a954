import { expect, test } from "vitest";
import { firstPathsFor } from "../../../src/renderer/workload";

const scene = (shapeCount: number, lightCount: number) => ({ shapes: Array(shapeCount), lightCount });

test("a plain scene starts with enough paths to tell an adapter's pace", () => {
  expect(firstPathsFor(scene(7, 1), false, 8, 1)).toBeGreaterThan(7000);
  expect(firstPathsFor(scene(7, 1), false, 0, 1)).toBe(8192);
});

test.each([
  ["1024 bounces with 8 light samples", scene(28, 25), false, 1024, 8],
  ["200,000 triangles, 64 bounces, 16 light samples", scene(2, 1), true, 64, 16],
  ["16,384 lights", scene(0, 16384), false, 8, 1],
] as const)("%s start with a handful", (_, parts, hasTree, bounces, lightSamples) => {
  expect(firstPathsFor(parts, hasTree, bounces, lightSamples)).toBeLessThan(40);
});

test("there is always one", () => {
  expect(firstPathsFor(scene(1, 1e6), true, 1024, 1024)).toBe(1);
});
