import { writeFile } from "node:fs/promises";
import { parseArgs } from "node:util";
import { encode } from "fast-png";
import { RtViewerError } from "../errors";
import { missingVariant } from "../loaders/missingVariant";
import { encodePfm } from "../renderer/encodePfm";
import { PathTracer } from "../renderer/pathTracer";
import type { Settings } from "../renderer/settings";
import { requestDawnDevice } from "./dawn";
import { readScene } from "./readScene";

const USAGE = `Usage: npm run render -- SCENE [options]
  SCENE               .json, .glb or .gltf
  --size WxH          pixels, default 256x256
  --samples N         per pixel, default 64
  --seed N            default 1
  --bounces N         default: the scene's maxBounces
  --variant NAME      of a glTF file with variants
  --light-samples N   light points per hit, default 1
  --estimator NAME    path (default) or uniform
  --sampler NAME      sobol (default) or independent
  --target-error E    stop once the estimated relative RMSE is at most E, or at --samples
  --out FILE          .png, tone-mapped, or .pfm, linear float
`;

const OPTIONS = {
  size: { type: "string", default: "256x256" },
  samples: { type: "string", default: "64" },
  seed: { type: "string", default: "1" },
  bounces: { type: "string" },
  variant: { type: "string" },
  "light-samples": { type: "string", default: "1" },
  estimator: { type: "string", default: "path" },
  sampler: { type: "string", default: "sobol" },
  "target-error": { type: "string", default: "0" },
  out: { type: "string" },
  help: { type: "boolean", default: false },
} as const;

/** A mistake on the command line. */
class UsageError extends RtViewerError {
  override readonly name = "UsageError";
}

/** `npm run render`: a scene file, JSON or glTF, becomes a picture, without a display. Prints one line of JSON last. */
export async function main(args: string[]): Promise<void> {
  try {
    await render(args);
  } catch (error) {
    if (!(error instanceof RtViewerError)) throw error;
    console.error(error.message);
    process.exit(1);
  }
  process.exit(0); // Dawn keeps the process alive
}

async function render(args: string[]): Promise<void> {
  const { values, positionals } = parse(args);
  if (values.help) return console.log(USAGE);
  const [file, ...rest] = positionals;
  if (file === undefined || rest.length > 0) throw new UsageError(`expected one scene file\n\n${USAGE}`);
  const [width, height] = sizeOf(values.size);
  const samples = integer("--samples", values.samples, 1);
  const write = values.out === undefined ? undefined : writerFor(values.out);
  const settings: Partial<Settings> = {
    seed: integer("--seed", values.seed, 0),
    lightSamples: integer("--light-samples", values["light-samples"], 1),
    estimator: oneOf("--estimator", values.estimator, ["path", "uniform"]),
    sampler: oneOf("--sampler", values.sampler, ["sobol", "independent"]),
    targetError: fraction("--target-error", values["target-error"]),
    ...(values.bounces !== undefined && { maxBounces: integer("--bounces", values.bounces, 0) }),
  };

  const device = await requestDawnDevice();
  const { scene, warnings, variants } = await readScene(file, device.limits, values.variant);
  if (values.variant !== undefined && !variants.includes(values.variant)) {
    throw new UsageError(`--variant: ${missingVariant(file, values.variant, variants)}`);
  }
  for (const warning of warnings) console.error(warning);
  const tracer = await PathTracer.create({
    scene,
    width,
    height,
    settings,
    device,
  });
  const firstCompileSeconds = tracer.stats.compileSeconds;
  await tracer.compile();
  const compileSeconds = firstCompileSeconds + tracer.stats.compileSeconds;
  const start = performance.now();
  await tracer.sample(samples);
  const seconds = (performance.now() - start) / 1000;
  await write?.(tracer);

  const { adapter, error, badSamples } = tracer.stats;
  const mpaths = (width * height * tracer.stats.samples) / seconds / 1e6;
  console.log(
    JSON.stringify({
      adapter,
      width,
      height,
      samples: tracer.stats.samples,
      seconds,
      compileSeconds,
      mpaths,
      error,
      badSamples,
    }),
  );
  tracer.dispose();
}

function parse(args: string[]) {
  try {
    return parseArgs({ args, options: OPTIONS, allowPositionals: true });
  } catch (error) {
    throw new UsageError(`${(error as Error).message}\n\n${USAGE}`);
  }
}

function writerFor(file: string): (tracer: PathTracer) => Promise<void> {
  if (file.endsWith(".png")) {
    return async (tracer) => {
      const { width, height } = tracer;
      await writeFile(file, encode({ width, height, data: await tracer.readPicture(), channels: 4 }));
    };
  }
  if (file.endsWith(".pfm")) {
    return async (tracer) => writeFile(file, encodePfm(await tracer.readRadiance(), tracer.width, tracer.height));
  }
  throw new UsageError(`--out: expected a file that ends in .png or .pfm, got ${file}`);
}

function sizeOf(text: string): [number, number] {
  const [width, height, ...rest] = text.split("x").map(Number);
  if (![width, height].every((side) => Number.isInteger(side) && side! > 0 && side! <= 16384) || rest.length > 0) {
    throw new UsageError(`--size: expected WIDTHxHEIGHT in pixels, such as 256x256, got ${text}`);
  }
  return [width!, height!];
}

function integer(option: string, text: string, least: number): number {
  const value = Number(text);
  if (text.trim() !== "" && Number.isInteger(value) && value >= least && value < 2 ** 32) return value;
  throw new UsageError(`${option}: expected an integer ≥ ${least}, got ${text}`);
}

function fraction(option: string, text: string): number {
  const value = Number(text);
  if (text.trim() !== "" && Number.isFinite(value) && value >= 0) return value;
  throw new UsageError(`${option}: expected a number ≥ 0, got ${text}`);
}

function oneOf<const T extends string>(option: string, text: string, choices: readonly T[]): T {
  const choice = choices.find((candidate) => candidate === text);
  if (choice) return choice;
  throw new UsageError(`${option}: expected ${choices.join(" or ")}, got ${text}`);
}
