import { loadReference } from "../support/reference";
import type { Measurement, MeasureOptions, TimedImage } from "./measurement";
import type { Options, SceneName } from "./options";
import { mainCount, pilotCount, sampleCounts } from "./plan";
import type { Renderer } from "./renderers";
import type { NotMeasured, Row } from "./results";
import { excess, halve, noise } from "./statistics";

/** One renderer with one scene, over all runs. */
type Entry = {
  readonly scene: SceneName;
  readonly renderer: Renderer;
  /** Of a short render before the first run. */
  readonly pilot: Measurement;
  /** Samples per pixel, as asked for; a renderer may round up. */
  readonly counts: readonly number[];
  /** Per count, of every run. */
  readonly seconds: readonly number[][];
  /** Per count, of the first two runs, whose seeds differ. */
  readonly images: readonly TimedImage[][];
};

type Wanted = Pick<Options, "scenes" | "size" | "samples" | "runs">;

/**
 * Renders every scene with every renderer, several times. Within a run the renderers take their turn at a scene one right
 * after the other, so that whatever else the machine does meets them all.
 *
 * A renderer that fails is left out of its scene, with the reason.
 */
export async function measureScenes(
  renderers: readonly Renderer[],
  { scenes, size, samples, runs }: Wanted,
  say: (line: string) => void,
): Promise<{ rows: Row[]; notMeasured: NotMeasured[] }> {
  const notMeasured: NotMeasured[] = [];
  const square = { width: size, height: size };

  /** Images as asked for, or undefined once the renderer has failed. */
  async function attempt(renderer: Renderer, scene: SceneName, options: MeasureOptions) {
    const label = `${scene}, ${renderer.id}, ${renderer.host}`;
    try {
      const measurement = checked(await renderer.measure(scene, options), options);
      const times = measurement.images.map(({ samples, seconds }) => `${samples} in ${seconds.toFixed(2)} s`);
      say(`${label}: ${times.join(", ")}`);
      return measurement;
    } catch (error) {
      const reason = (error as Error).message.split("\n")[0]!;
      say(`${label}: ${reason}`);
      notMeasured.push({ id: renderer.id, scene, reason });
      return undefined;
    }
  }

  say("Short renders, to see what is affordable");
  let entries: Entry[] = [];
  for (const scene of scenes) {
    for (const renderer of renderers) {
      if (!(renderer.scenes?.includes(scene) ?? true)) {
        notMeasured.push({
          id: renderer.id,
          scene,
          reason: "its set-up takes half a minute; three scenes were thought enough",
        });
        continue;
      }
      const pilot = await attempt(renderer, scene, { ...square, samples: [pilotCount(samples)], seed: 1 });
      if (!pilot) continue;
      const [image] = pilot.images;
      const counts = sampleCounts(samples, image!.seconds / image!.samples);
      const [seconds, images] = [counts.map(() => []), counts.map(() => [])];
      entries.push({ scene, renderer, pilot, counts, seconds, images });
    }
  }

  for (let run = 0; run < runs; run++) {
    say(`Run ${run + 1} of ${runs}`);
    const kept: Entry[] = [];
    for (const entry of entries) {
      const { scene, renderer, counts } = entry;
      const measurement = await attempt(renderer, scene, { ...square, samples: counts, seed: 1 + (run % 2) });
      if (!measurement) continue;
      measurement.images.forEach((image, i) => {
        entry.seconds[i]!.push(image.seconds);
        if (run < 2) entry.images[i]!.push(image);
      });
      kept.push(entry);
    }
    entries = kept;
  }
  return { rows: entries.flatMap((entry) => rowsOf(entry, size, samples)), notMeasured };
}

function rowsOf({ scene, renderer, pilot, counts, seconds, images }: Entry, size: number, samples: number): Row[] {
  const main = mainCount(counts, samples);
  return counts.map((count, i) => {
    const [{ samples, radiance: first }, { radiance: second }] = images[i] as [TimedImage, TimedImage];
    const { width, ...reference } = loadReference(scene);
    const isMain = count === main;
    const halved = (image: Float32Array) => halve(image, size, size);
    return {
      scene,
      id: renderer.id,
      renderer: pilot.renderer,
      host: renderer.host,
      adapter: pilot.adapter,
      samples,
      isMain,
      seconds: seconds[i]!,
      setupSeconds: pilot.setupSeconds,
      ...noise(first, second),
      ...(isMain && size === 2 * width && { bias: excess(halved(first), halved(second), reference) }),
    };
  });
}

/** @throws {Error} if a renderer did not do what it was asked to. */
function checked(measurement: Measurement, { width, height, samples }: MeasureOptions): Measurement {
  const { images } = measurement;
  if (images.length !== samples.length) throw new Error(`expected ${samples.length} images, got ${images.length}`);
  const isWhole = ({ radiance }: TimedImage) =>
    radiance.length === 3 * width * height && radiance.every(Number.isFinite);
  if (!images.every(isWhole)) throw new Error("an image has the wrong size, or values that are not finite");
  return measurement;
}
