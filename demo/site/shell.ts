// What all pages share: the head, the header with the way around, and the footer.

const SECTIONS = [
  { path: "index.html", href: "", label: "Gallery" },
  { path: "features.html", href: "features.html", label: "Features" },
  { path: "playground.html", href: "playground.html", label: "Playground" },
  { path: "performance.html", href: "performance.html", label: "Performance" },
] as const;

const ICON =
  "data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 32 32'%3E%3CradialGradient id='g' cx='.35' cy='.3' r='.8'%3E" +
  "%3Cstop stop-color='%23ffe9bd'/%3E%3Cstop offset='.5' stop-color='%23d9982f'/%3E%3Cstop offset='1' stop-color='%235a3208'/%3E" +
  "%3C/radialGradient%3E%3Ccircle cx='16' cy='16' r='14' fill='url(%23g)'/%3E%3C/svg%3E";

/** The way from a page to the site's root, relative, so that the site works under any address: `"./"`, `"../"`. */
export function rootOf(path: string): string {
  return path.includes("/") ? "../".repeat(path.split("/").length - 1) : "./";
}

/** What stands first in every page's head. */
export function sharedHead(path: string): string {
  return `<meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <meta name="color-scheme" content="light dark" />
    <link rel="icon" href="${ICON}" />
    <link rel="stylesheet" href="${rootOf(path)}style.css" />`;
}

/** What stands before every page's `<main id="main">`. */
export function siteHeader(path: string): string {
  const root = rootOf(path);
  const links = SECTIONS.map((section) => {
    const current = section.path === path ? "page" : isWithin(path, section.path) ? "true" : undefined;
    return `<li><a href="${root}${section.href}"${current === undefined ? "" : ` aria-current="${current}"`}>${section.label}</a></li>`;
  });
  return `<a class="skip" href="#main">Skip to the content</a>
    <header class="site">
      <a class="wordmark" href="${root}"><span class="ball" aria-hidden="true"></span>rt-viewer</a>
      <nav aria-label="Site"><ul>${links.join("")}</ul></nav>
    </header>`;
}

/** What stands after every page's `<main>`. */
export function siteFooter(): string {
  return `<footer class="site">
      <p>
        The scenes of the gallery, but the bottle, are tested, pixel by pixel, against <a href="https://mitsuba-renderer.org">Mitsuba 3</a> at
        65,536 samples per pixel. rt-viewer is free software under the MIT licence.
      </p>
    </footer>`;
}

/** `features.html` leads to everything in `features/`. */
function isWithin(path: string, section: string): boolean {
  return path.startsWith(`${section.replace(/\.html$/, "")}/`);
}
