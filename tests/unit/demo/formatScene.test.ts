import { readdirSync, readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { formatScene } from "../../../demo/playground/formatScene";

const FOLDER = new URL("../../reference/scenes/", import.meta.url);

describe("formatScene", () => {
  test.each(readdirSync(FOLDER))("changes nothing in %s, and keeps its lines short but those of data", (name) => {
    const scene: unknown = JSON.parse(readFileSync(new URL(name, FOLDER), "utf8"));
    const text = formatScene(scene);
    expect(JSON.parse(text)).toEqual(scene);
    const lines = text.split("\n").filter((line) => !/^ *"(positions|indices|normals|uvs|texels)": \[/.test(line));
    expect(lines.every(({ length }) => length <= 120)).toBe(true);
  });

  test("writes a vector and a small object on one line, and a mesh's numbers too", () => {
    const scene = { camera: { position: [0, 1, 2] }, objects: [{ type: "mesh", positions: Array(300).fill(0.5) }] };
    expect(formatScene(scene).split("\n")[1]).toBe('  "camera": { "position": [0, 1, 2] },');
    expect(formatScene(scene).split("\n").length).toBeLessThan(12);
    expect(formatScene({ objects: [], materials: {} })).toBe('{\n  "objects": [],\n  "materials": {}\n}\n');
  });
});
