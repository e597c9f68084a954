import type { RtViewerElement } from "rt-viewer/element";

/** Gives each viewer its scene once the one before it shows a picture, so that the first one is not kept waiting. */
export async function loadInTurn(viewers: readonly RtViewerElement[]): Promise<void> {
  for (const viewer of viewers) {
    const settled = new Promise<void>((resolve) => {
      for (const type of ["ready", "error"]) viewer.addEventListener(type, () => resolve(), { once: true });
    });
    viewer.src = viewer.dataset.src ?? "";
    await settled;
  }
}

/** Whether an adapter is a CPU in disguise. */
export function isSoftware(adapter: string): boolean {
  return /swiftshader|llvmpipe|lavapipe|software|basic render|warp/i.test(adapter);
}
