import { parser } from "@lezer/json";
import { describe, expect, test } from "vitest";
import { check } from "../../../demo/playground/check";
import { parsePath, positionOf } from "../../../demo/playground/jsonPosition";

const SCENE = `{
  "camera": { "position": [0, 0, 5] },
  "materials": { "old \\"gold\\"": { "roughness": 0.5 } },
  "objects": [
    { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "old \\"gold\\"" }
  ]
}`;

const checked = (text: string) => check(text, parser.parse(text));
const marked = (text: string) => checked(text).problems.map(({ from, to, message }) => [text.slice(from, to), message]);

describe("check", () => {
  test("a text without mistakes is a scene", () => {
    expect(checked(SCENE)).toEqual({ problems: [], scene: JSON.parse(SCENE) });
  });

  test("marks a wrong value with its key, every one of them, in the text's order", () => {
    const text = SCENE.replace("0.5", "5").replace('"radius": 1', '"radius": -1').replace("[0, 0, 5]", "[0, 0, true]");
    expect(marked(text)).toEqual([
      ["true", expect.stringContaining("got true")],
      ['"roughness": 5', expect.stringContaining("got 5")],
      ['"radius": -1', expect.stringContaining("got -1")],
    ]);
  });

  test("marks what a missing value is missing from, to the end of its line", () => {
    const text = SCENE.replace(' "radius": 1,', "");
    expect(marked(text)).toEqual([[text.split("\n")[4]!.trim(), expect.stringContaining("got nothing")]]);
    expect(marked("{}").every(([mark]) => mark === "{}")).toBe(true);
  });

  test.each([
    ["a missing comma", SCENE.replace('] },\n  "materials"', '] }\n  "materials"'), 3],
    ["a word", SCENE.replace('"radius": 1', '"radius": one'), 5],
    ["a comma too many", SCENE.replace("0.5 }", "0.5, }"), 3],
    ["an end that is missing", SCENE.slice(0, -1), 6],
    ["nothing at all", "", 1],
  ])("places %s on its line, in a few words", (_, text, line) => {
    const { problems, scene } = checked(text);
    expect(scene).toBeUndefined();
    expect(problems).toHaveLength(1);
    expect(text.slice(0, problems[0]!.from).split("\n")).toHaveLength(line);
    expect(problems[0]!.message).not.toMatch(/position|SyntaxError|\.\.\./);
    expect(problems[0]!.to).toBeLessThanOrEqual(text.length);
  });

  test("survives what is no scene: a number, null, deep nesting", () => {
    for (const text of ["1", "null", '"x"', `${"[".repeat(2000)}${"]".repeat(2000)}`]) {
      expect(checked(text).problems.length).toBeGreaterThan(0);
    }
  });
});

describe("positionOf", () => {
  test("follows paths as parseScene writes them", () => {
    expect(parsePath('materials["old \\"gold\\""].baseColor[2]')).toEqual(["materials", 'old "gold"', "baseColor", 2]);
    expect(parsePath("")).toEqual([]);
  });

  test("stops at the last part that is there", () => {
    const { from } = positionOf(["objects", 0, "center", 7], SCENE, parser.parse(SCENE));
    expect(SCENE.slice(from)).toMatch(/^"center"/);
  });
});
