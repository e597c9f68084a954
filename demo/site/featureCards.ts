import { FEATURE_GROUPS } from "../features/list";
import { readFeature } from "./feature";

/** The list of all feature pages, by group, each with its picture. */
export function featureCards(): string {
  return FEATURE_GROUPS.map(
    ({ title, names }) => `<section class="group">
        <h2>${title}</h2>
        <ul class="cards">
          ${names.map(card).join("\n          ")}
        </ul>
      </section>`,
  ).join("\n      ");
}

function card(name: string): string {
  const { title, description } = readFeature(name);
  return `<li>
            <a href="./features/${name}.html">
              <img vite-ignore src="posters/${name}.webp" width="640" height="427" loading="lazy" alt="" />
              <b>${title}</b>
            </a>
            <p>${description}</p>
          </li>`;
}
