import type { Scene } from "rt-viewer";
import type { RtViewerElement } from "rt-viewer/element";

/** Scenes made by code, by the `data-model` of their viewers. */
const MODELS: { readonly [name: string]: () => Promise<Scene> } = {
  perfume: async () => (await import("./perfume")).perfumeScene(),
};

/** Gives each viewer its scene once the one before it shows a picture, so that the first one is not kept waiting. */
export async function loadInTurn(viewers: readonly RtViewerElement[]): Promise<void> {
  for (const viewer of viewers) {
    const settled = new Promise<void>((resolve) => {
      for (const type of ["ready", "error"]) viewer.addEventListener(type, () => resolve(), { once: true });
    });
    const { src = "", model = "" } = viewer.dataset;
    if (MODELS[model] !== undefined) viewer.scene = await MODELS[model]();
    else viewer.src = src;
    await settled;
  }
}

/** Whether an adapter is a CPU in disguise. */
export function isSoftware(adapter: string): boolean {
  return /swiftshader|llvmpipe|lavapipe|software|basic render|warp/i.test(adapter);
}
