import { readdirSync, readFileSync } from "node:fs";
import { expect, test } from "vitest";

const SRC = new URL("../../src/", import.meta.url);

test.each(["element", "panel", "loaders", "scene"])(
  "nothing in %s imports from the compiler of scenes, not even a type",
  (folder) => {
    const files = readdirSync(new URL(folder, SRC), { recursive: true, encoding: "utf8" }).filter((name) =>
      name.endsWith(".ts"),
    );
    expect(files).not.toEqual([]);
    const found = files.flatMap((file) => {
      const names = [
        ...readFileSync(new URL(`${folder}/${file}`, SRC), "utf8").matchAll(/(?:from|import\() ?"([^"]+)"/g),
      ];
      return names.filter(([, name]) => /\/compile\//.test(name!)).map(([, name]) => [file, name]);
    });
    expect(found).toEqual([]);
  },
);
