import { readdirSync, readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { FEATURE_NAMES } from "../../../demo/features/list";
import { parseFeature } from "../../../demo/site/feature";
import { completePage } from "../../../demo/site/plugin";

const FOLDER = new URL("../../../demo/", import.meta.url);
const read = (path: string) => readFileSync(new URL(path, FOLDER), "utf8");

/** The text that a browser finds in an element of the page. */
function textOf(page: string, id: string): string {
  const html = new RegExp(`<code id="${id}">(.*?)</code>`, "s").exec(page)?.[1] ?? "";
  const text = html.replaceAll(/<\/?span[^>]*>/g, "");
  return text.replaceAll("&lt;", "<").replaceAll("&gt;", ">").replaceAll("&quot;", '"').replaceAll("&amp;", "&");
}

describe("a feature page", () => {
  test("is there for every file of the folder, and no other", () => {
    const files = readdirSync(new URL("features/", FOLDER)).filter((name) => name.endsWith(".html"));
    expect([...FEATURE_NAMES].sort()).toEqual(files.map((name) => name.replace(/\.html$/, "")).sort());
  });

  test.each(FEATURE_NAMES)("of %s shows the code that it runs, to the letter", (name) => {
    const page = completePage(`features/${name}.html`, read(`features/${name}.html`));
    expect(page).toContain(`<script type="module" src="./${name}.ts"></script>`);
    expect(textOf(page, "code")).toBe(read(`features/${name}.ts`).trimEnd());
    const markup = textOf(page, "markup");
    expect(markup).toContain("<rt-viewer ");
    expect(page.split(markup)).toHaveLength(2); // once as it is; the code shown is escaped
    expect(page.match(/<h1/g)).toHaveLength(1);
  });

  test("says which file is not laid out like the others", () => {
    expect(() => parseFeature("odd", "<title>Odd</title>", "")).toThrow(
      "features/odd.html is not laid out like the other",
    );
  });
});

describe("a page", () => {
  test.each([
    ["index.html", "./", "Gallery"],
    ["playground.html", "./", "Playground"],
    ["features/metals.html", "../", "Features"],
  ])("%s has the shared frame, leads around relatively, and marks its section", (path, root, label) => {
    const page = completePage(path, read(path));
    expect(page).toContain(`<link rel="stylesheet" href="${root}style.css" />`);
    expect(page).toContain(`href="${root}performance.html"`);
    expect(/aria-current="(?:page|true)">(\w+)</.exec(page)?.[1]).toBe(label);
    expect(page).toContain('<a class="skip" href="#main">');
    expect(page.match(/<main id="main"/g)).toHaveLength(1);
    expect(page).not.toMatch(/(?:href|src)="\//);
  });
});
