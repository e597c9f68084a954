import { readdirSync, readFileSync } from "node:fs";
import { posix } from "node:path";
import { describe, expect, test } from "vitest";

const SRC = new URL("../../src/", import.meta.url);
const FILES = readdirSync(SRC, { recursive: true, encoding: "utf8" }).filter((name) => name.endsWith(".ts"));

/** By file, the files that it imports, types included. */
const IMPORTS = new Map(
  FILES.map((file) => {
    const text = readFileSync(new URL(file, SRC), "utf8");
    const names = [...text.matchAll(/(?:from|import\() ?"(\.[^"]+)"/g)].map(([, name]) => name!);
    return [
      file,
      names.map((name) => `${posix.join(posix.dirname(file), name)}.ts`).filter((name) => FILES.includes(name)),
    ];
  }),
);

// What each folder may import, beside itself and the files of the root: whoever reads from the top can stop at any line.
const LEFT: Readonly<Record<string, string>> = {
  math: "",
  scene: "",
  bvh: "",
  lights: "math scene",
  lobes: "math scene",
  shapes: "math scene lights",
  tree: "math scene lights lobes shapes bvh",
  compile: "math scene lights lobes shapes tree",
  gpu: "compile tree",
  renderer: "math scene shapes tree compile gpu",
  loaders: "math scene",
  panel: "scene renderer",
  element: "math scene renderer gpu loaders panel",
  frameworks: "scene renderer element",
  cli: "scene gpu renderer loaders",
};

const folderOf = (file: string) => (file.includes("/") ? file.split("/")[0]! : "");

describe("imports point one way", () => {
  test.each(Object.entries(LEFT))("%s imports nothing but %s", (folder, left) => {
    const allowed = ["", folder, ...left.split(" ")];
    const files = FILES.filter((file) => folderOf(file) === folder);
    expect(files).not.toEqual([]);
    const wrong = files.flatMap((file) =>
      IMPORTS.get(file)!.flatMap((name) => (allowed.includes(folderOf(name)) ? [] : [`${file} imports ${name}`])),
    );
    expect(wrong).toEqual([]);
  });

  test("every folder has its place", () => {
    expect(Object.keys(LEFT).sort()).toEqual([...new Set(FILES.map(folderOf))].filter((folder) => folder).sort());
  });

  test("no file imports itself by way of others, where scenes are compiled", () => {
    const pure = FILES.filter((file) => /^(math|bvh|lights|lobes|shapes|tree|compile|gpu|renderer)\//.test(file));
    const reachable = (start: string) => {
      const seen = new Set<string>();
      const next = [...IMPORTS.get(start)!];
      for (let file = next.pop(); file !== undefined; file = next.pop()) {
        if (!seen.has(file)) next.push(...IMPORTS.get(file)!);
        seen.add(file);
      }
      return seen;
    };
    expect(pure.filter((file) => reachable(file).has(file))).toEqual([]);
  });
});
