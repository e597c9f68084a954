import { CompletionContext } from "@codemirror/autocomplete";
import { json } from "@codemirror/lang-json";
import { EditorState } from "@codemirror/state";
import { beforeAll, describe, expect, test } from "vitest";
import { completeScene } from "../../../demo/playground/complete";
import type { JsonSchema } from "../../../demo/playground/schemaWalk";
import { createSceneSchema } from "../../../tools/sceneSchema";

let schema: JsonSchema;
beforeAll(async () => {
  schema = await createSceneSchema();
});

/** What is suggested at the `|`. */
function suggestions(marked: string, explicit = true) {
  const position = marked.indexOf("|");
  const state = EditorState.create({ doc: marked.replace("|", ""), extensions: [json()] });
  return completeScene(schema)(new CompletionContext(state, position, explicit));
}
const labels = (marked: string, explicit = true) =>
  suggestions(marked, explicit)?.options.map(({ label }) => label) ?? [];

describe("completeScene", () => {
  test("suggests the keys that are not there yet", () => {
    expect(labels('{ "camera": { "position": [0, 0, 5], "|" } }')).toEqual([
      '"target"',
      '"up"',
      '"verticalFov"',
      '"orthographicHeight"',
      '"aperture"',
      '"focusDistance"',
    ]);
    expect(labels('{ "camera": {}, | }')).toContain('"objects"');
  });

  test("writes a key with a value to start from, and the comma that is needed", () => {
    const fov = suggestions('{ "camera": { "verti|" } }')!.options.find(({ label }) => label === '"verticalFov"');
    expect(fov).toMatchObject({ apply: '"verticalFov": 45', detail: "= 45", info: expect.stringContaining("degrees") });
    const target = suggestions('{ "camera": { "tar|" "up": [0, 1, 0] } }')!.options[1];
    expect(target).toMatchObject({ apply: '"target": [0, 0, 0],' });
    expect(suggestions('{ "camera": { "tar|": [0, 0, 0] } }')!.options).toContainEqual(
      expect.objectContaining({ apply: '"target"' }),
    );
  });

  test("takes the place of the whole key or word, with its quotes", () => {
    const place = (marked: string) => {
      const { from, to = Number.NaN } = suggestions(marked)!;
      return marked.replace("|", "").slice(from, to);
    };
    expect(place(`{ "camera": { "position": [0, 0, 5] },${" ".repeat(2000)}"max|B" }`)).toBe('"maxB"');
    expect(place('{ "materials": { "a": { "masking": "sm|i" } } }')).toBe('"smi"');
    expect(place('{ "camera": {}, | }')).toBe("");
  });

  test("knows an object by its type, and asks for that first", () => {
    expect(labels('{ "objects": [{ "|" }] }')).toEqual(['"type"']);
    expect(labels('{ "objects": [{ "type": "sphere", "|" }] }')).toEqual(['"center"', '"radius"', '"material"']);
    expect(labels('{ "objects": [{ "type": "|" }] }')).toContain('"plane"');
  });

  test("knows a texture by its name and as an object", () => {
    const scene = (reference: string) =>
      `{ "textures": { "wood": {} }, "materials": { "a": { "normalTexture": ${reference} } } }`;
    expect(labels(scene('"|"'))).toEqual(['"wood"']);
    expect(labels(scene('{ "texture": "|" }'))).toEqual(['"wood"']);
    expect(labels(scene('{ "texture": "wood", "|" }'))).toEqual(['"uv"', '"offset"', '"scale"', '"rotation"']);
    expect(labels(scene('{ "uv": | }'))).toEqual(["0", "1"]);
    const keys = suggestions('{ "materials": { "a": { "norm|" } } }')!.options;
    expect(keys).toContainEqual(expect.objectContaining({ apply: '"normalTexture": ""' }));
  });

  test("suggests words where there is a choice, and the scene's own materials", () => {
    expect(labels('{ "materials": { "a": { "masking": "|" } } }')).toEqual(['"smith"', '"schlick-beckmann"']);
    expect(labels('{ "materials": { "a": { "multiscatter": | } } }')).toEqual(["true", "false"]);
    const scene = '{ "materials": { "red": {}, "old gold": {} }, "objects": [{ "type": "sphere", "material": "|" }] }';
    expect(labels(scene)).toEqual(['"red"', '"old gold"']);
  });

  test("keeps quiet where nothing is known, and between things unless asked", () => {
    expect(labels('{ "materials": { "|" } }')).toEqual([]);
    expect(labels('{ "nonsense": { "|" } }')).toEqual([]);
    expect(labels('{ "camera": {}, | }', false)).toEqual([]);
    expect(labels("|")).toEqual([]);
  });
});
