import { expect, test } from "vitest";
import { firstPathsFor } from "../../../src/renderer/firstPathsFor";

const scene = (shapeCount: number, lightCount: number) => ({ shapes: Array(shapeCount), lightCount });
/** A tree of meshes and of so many other shapes. */
const treeOf = (shapeCount: number) => ({ shapes: new Map(Array.from({ length: shapeCount }, (_, id) => [id, id])) });

test("a plain scene starts with enough paths to tell an adapter's pace", () => {
  expect(firstPathsFor(scene(7, 1), undefined, 8, 1)).toBeGreaterThan(7000);
  expect(firstPathsFor(scene(7, 1), undefined, 0, 1)).toBe(8192);
});

test.each([
  ["1024 bounces with 8 light samples", scene(28, 25), undefined, 1024, 8],
  ["200,000 triangles, 64 bounces, 16 light samples", scene(2, 1), treeOf(0), 64, 16],
  ["16,384 lights", scene(0, 16384), undefined, 8, 1],
] as const)("%s start with a handful", (_, parts, tree, bounces, lightSamples) => {
  expect(firstPathsFor(parts, tree, bounces, lightSamples)).toBeLessThan(40);
});

test("shapes in a tree cost as much whatever their number, and planes each their share", () => {
  const few = firstPathsFor(scene(100, 1), treeOf(98), 8, 1);
  expect(firstPathsFor(scene(32_768, 1), treeOf(32_766), 8, 1)).toBe(few);
  expect(firstPathsFor(scene(33_768, 1), treeOf(32_766), 8, 1)).toBeLessThan(few / 2);
});

test("there is always one", () => {
  expect(firstPathsFor(scene(1, 1e6), treeOf(0), 1024, 1024)).toBe(1);
});
