import { ORIGINAL_SETTINGS } from "../../demo/performance/originalSettings";
import { loadReference } from "../support/reference";
import type { Host } from "./measurement";
import type { Options } from "./options";
import type { FrameRow } from "./results";
import { noise } from "./statistics";

/** The original's settings with our scene of the original's kind, both estimators. */
export async function measureOriginalTable(host: Host, { isQuick }: Pick<Options, "isQuick">): Promise<FrameRow[]> {
  const { scene } = loadReference("spheres");
  const size = isQuick ? { width: 64, height: 36 } : { width: 320, height: 180 };
  const rows: FrameRow[] = [];
  for (const { rays, bounces, lightSamples } of ORIGINAL_SETTINGS) {
    for (const estimator of ["path", "uniform"] as const) {
      const frame = { ...size, estimator, rays, bounces, lightSamples };
      const { adapter, seconds, images } = await host.frames(scene, { ...frame, frames: isQuick ? 3 : 7 });
      rows.push({ host: host.name, adapter, ...frame, seconds, ...noise(...images) });
    }
  }
  return rows;
}
