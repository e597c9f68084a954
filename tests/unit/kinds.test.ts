import { readdirSync, readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { LIGHT_KINDS } from "../../src/lights/lights";
import { SHAPE_KINDS } from "../../src/shapes/shapes";

const SRC = new URL("../../src/", import.meta.url);

// Where kinds live, and glTF's own words for its lights.
const ROOMS = /^(shapes|lights|lobes|scene)\/|^loaders\/gltf\/(schema|convertLights)\.ts$/;

test("only the rooms of shapes and lights, and the scene's format, name their kinds", () => {
  const kinds = new RegExp(`["'\`](${[...Object.keys(SHAPE_KINDS), ...Object.keys(LIGHT_KINDS)].join("|")})["'\`]`);
  const named = readdirSync(SRC, { recursive: true, encoding: "utf8" })
    .filter((name) => name.endsWith(".ts") && !ROOMS.test(name))
    .flatMap((name) =>
      readFileSync(new URL(name, SRC), "utf8")
        .split("\n")
        .map((line) => ({ name, line })),
    )
    // Comments may give examples.
    .filter(({ line }) => kinds.test(line) && !/^\s*(\*|\/\/|\/\*)/.test(line));
  expect(named).toEqual([]);
});
