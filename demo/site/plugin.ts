import { relative, sep } from "node:path";
import { fileURLToPath } from "node:url";
import type { Plugin } from "vite";
import { FEATURE_NAMES } from "../features/list";
import { readFeature } from "./feature";
import { featureCards } from "./featureCards";
import { featurePage } from "./featurePage";
import { sharedHead, siteFooter, siteHeader } from "./shell";

const ROOT = fileURLToPath(new URL("..", import.meta.url));
const FEATURE_PATH = /^features\/(?<name>.+)\.html$/;

/** Every page of the site, as input of the build. */
export function sitePages(): readonly string[] {
  const sections = ["index", "features", "playground", "performance"];
  const paths = [...sections, ...FEATURE_NAMES.map((name) => `features/${name}`)];
  return paths.map((path) => `${ROOT}${path}.html`);
}

/** Puts what the pages share around what each has to say. */
export function site(): Plugin {
  return {
    name: "site",
    transformIndexHtml: {
      order: "pre",
      handler: (html, { filename }) => completePage(relative(ROOT, filename).split(sep).join("/"), html),
    },
  };
}

/**
 * A file of this folder as a whole page: with the shared head, header and footer; a feature's file becomes its page.
 *
 * @param path - relative to the site's root, with slashes.
 */
export function completePage(path: string, html: string): string {
  const name = FEATURE_PATH.exec(path)?.groups?.name;
  const page = name === undefined ? html : featurePage(readFeature(name));
  // Functions, because a `$` in what is put in has no meaning here.
  return page
    .replace("<head>", () => `<head>\n    ${sharedHead(path)}`)
    .replace(/<body[^>]*>/, (body) => `${body}\n    ${siteHeader(path)}`)
    .replace("<!-- feature cards -->", featureCards)
    .replace("</body>", () => `  ${siteFooter()}\n  </body>`);
}
