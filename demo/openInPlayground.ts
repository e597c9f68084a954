import type { Scene } from "rt-viewer";
import { formatScene } from "./playground/formatScene";
import { toHash } from "./playground/link";

// Leads from a feature's picture to the playground, with the scene as it is on the page.

const link = document.querySelector<HTMLAnchorElement>("[data-playground]");
const viewer = document.querySelector("rt-viewer");

link?.addEventListener("click", async (event) => {
  if (event.button !== 0 || event.metaKey || event.ctrlKey || event.shiftKey) return; // a new tab gets the plain address
  if (viewer === null) return;
  event.preventDefault();
  const scene = viewer.scene ?? ((await (await fetch(viewer.src)).json()) as Scene);
  location.href = link.href + (await toHash({ text: formatScene(scene), exposure: viewer.exposure }));
});
