import { loadReference, type Reference } from "../support/reference";
import type { Host } from "./measurement";
import type { Options } from "./options";
import type { EstimateRow } from "./results";
import { trueError } from "./statistics";

/**
 * The viewer's estimate of its error, and the truth, as the image of each scene grows; at the references' own size, and as long
 * as the truth is more than the reference's own noise.
 */
export async function measureEstimates(
  host: Host,
  { scenes, isQuick }: Pick<Options, "scenes" | "isQuick">,
): Promise<EstimateRow[]> {
  const samples = isQuick ? [8, 16, 32] : [8, 16, 32, 64, 128, 256, 512];
  const rows: EstimateRow[] = [];
  for (const scene of scenes) {
    const { scene: description, width, height, ...reference } = loadReference(scene);
    for (const sampler of ["sobol", "independent"] as const) {
      const images = await host.estimates(description, { width, height, samples, seed: 1, sampler });
      for (const { samples, estimate, radiance } of images) {
        const truth = trueError(radiance, reference);
        if (truth > ownError(reference)) rows.push({ scene, sampler, samples, estimate, truth });
      }
    }
  }
  return rows;
}

function ownError({ image, standardError }: Pick<Reference, "image" | "standardError">): number {
  const squares = standardError.reduce((sum, value) => sum + value ** 2, 0);
  return Math.sqrt(squares * image.length) / image.reduce((sum, value) => sum + value, 0);
}
