import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

/** A page that shows what a few lines of code do. */
export type Feature = {
  /** Of its files and its address. */
  readonly name: string;
  readonly title: string;
  /** One sentence, plain text. */
  readonly description: string;
  /** HTML that stands in the page and is shown as code: the viewer and what goes with it. */
  readonly markup: string;
  /** HTML: why the picture is right. */
  readonly text: string;
  /** TypeScript that runs in the page and is shown as code. */
  readonly code: string;
};

const LAYOUT =
  /^<title>(?<title>.*)<\/title>\n<meta name="description" content="(?<description>.*)" \/>\n\n(?<markup>.*?)\n\n<section>\n(?<text>.*)<\/section>\s*$/s;

/** @throws {Error} if there are no such files, or the HTML is not laid out like the others. */
export function readFeature(name: string): Feature {
  const read = (extension: string) =>
    readFileSync(fileURLToPath(new URL(`../features/${name}.${extension}`, import.meta.url)), "utf8");
  return parseFeature(name, read("html"), read("ts"));
}

/** @param html - title, description, markup and text, in this order, as in every file of `features/`. */
export function parseFeature(name: string, html: string, code: string): Feature {
  const parts = LAYOUT.exec(html)?.groups as Omit<Feature, "name" | "code"> | undefined;
  if (parts === undefined) throw new Error(`features/${name}.html is not laid out like the other features`);
  return { name, ...parts, code: code.trimEnd() };
}
