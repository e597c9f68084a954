import { FEATURE_NAMES } from "../features/list";
import { type Feature, readFeature } from "./feature";
import { highlight } from "./highlight";
import { rootOf } from "./shell";

/** The document of a feature page. The code it shows is the file that it runs. */
export function featurePage(feature: Feature): string {
  const { name, title, description, markup, text, code } = feature;
  const path = `features/${name}.html`;
  return `<!doctype html>
<html lang="en">
  <head>
    <title>${title} · rt-viewer</title>
    <meta name="description" content="${description}" />
    <link rel="stylesheet" href="${rootOf(path)}features.css" />
    <script type="module" src="./${name}.ts"></script>
    <script type="module" src="${rootOf(path)}openInPlayground.ts"></script>
  </head>
  <body>
    <main id="main" class="feature" tabindex="-1">
      <div class="result">
        ${markup}
      </div>
      <div class="why">
        <h1>${title}</h1>
        <p class="lead">${description}</p>
        ${text}
        <p class="actions"><a class="button" href="${rootOf(path)}playground.html" data-playground>Change it in the playground</a></p>
      </div>
      <section class="source" aria-labelledby="source-title">
        <h2 id="source-title">All it takes</h2>
        <pre tabindex="0" role="region" aria-label="HTML"><code id="markup">${highlight(markup, "html")}</code></pre>
        <pre tabindex="0" role="region" aria-label="TypeScript"><code id="code">${highlight(code, "ts")}</code></pre>
      </section>
      <nav class="neighbours" aria-label="Features">${neighbours(name)}</nav>
    </main>
  </body>
</html>`;
}

function neighbours(name: string): string {
  const at = FEATURE_NAMES.indexOf(name);
  const link = (neighbour: string | undefined, rel: string, label: string) =>
    neighbour === undefined
      ? ""
      : `<a href="./${neighbour}.html" rel="${rel}"><small>${label}</small>${readFeature(neighbour).title}</a>`;
  return link(FEATURE_NAMES[at - 1], "prev", "Before") + link(FEATURE_NAMES[at + 1], "next", "Next");
}
