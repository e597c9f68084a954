import { join } from "node:path";
import { parseArgs } from "node:util";
import { RtViewerError } from "../../src/errors";
import { ANALYTIC_NAMES } from "../support/reference";
import { VARIANTS } from "./measurement";

export type SceneName = (typeof ANALYTIC_NAMES)[number];

export const RENDERER_IDS = [...VARIANTS, "three-gpu-pathtracer", "mitsuba", "cycles"] as const;
export type RendererId = (typeof RENDERER_IDS)[number];

export const USAGE = `Usage: npm run bench -- [options]
  --scenes A,B       of ${ANALYTIC_NAMES.join(", ")}; default all
  --renderers A,B    of ${RENDERER_IDS.join(", ")}; default all
  --host NAME        where rt-viewer runs: chromium, dawn or both (default)
  --size N           pixels, N × N, default 256
  --samples N        per pixel, default 64
  --runs N           default 3, at least 2: the error comes from two seeds
  --gpu              Chromium on the machine's own driver instead of the software adapter
  --quick            a minute or less: cornell and spheres, rt-viewer alone, 64 × 64, 16 samples, 2 runs
  --out FOLDER       default tests/bench; tests/output/bench if anything above is given but --gpu;
                     with --from, the folder around the results'
  --from FILE.json   measure nothing; write report and plots from these results
`;

export type Options = {
  readonly scenes: readonly SceneName[];
  readonly renderers: readonly RendererId[];
  readonly hosts: readonly ("chromium" | "dawn")[];
  readonly size: number;
  readonly samples: number;
  readonly runs: number;
  readonly usesGpu: boolean;
  readonly isQuick: boolean;
  /** Folder for `results/`, `plots/` and the report. */
  readonly out: string;
  readonly from: string | undefined;
  readonly help: boolean;
};

/** A mistake on the command line. */
export class UsageError extends RtViewerError {
  override readonly name = "UsageError";
}

/** @throws {UsageError} */
export function parseOptions(args: readonly string[]): Options {
  const values = parse(args);
  const isQuick = values.quick ?? false;
  const { scenes, renderers, host, size, samples, runs, from } = values;
  // What is not the whole benchmark does not replace its report.
  const isPart = isQuick || [scenes, renderers, host, size, samples, runs].some((value) => value !== undefined);
  return {
    scenes: listOf("--scenes", scenes, ANALYTIC_NAMES, isQuick ? ["cornell", "spheres"] : ANALYTIC_NAMES),
    renderers: listOf("--renderers", renderers, RENDERER_IDS, isQuick ? VARIANTS : RENDERER_IDS),
    hosts: hostsOf(host ?? "both"),
    size: integer("--size", size, 2, isQuick ? 64 : 256),
    samples: integer("--samples", samples, 1, isQuick ? 16 : 64),
    runs: integer("--runs", runs, 2, isQuick ? 2 : 3),
    usesGpu: values.gpu ?? false,
    isQuick,
    out: values.out ?? (from === undefined ? (isPart ? "tests/output/bench" : "tests/bench") : join(from, "../..")),
    from,
    help: values.help ?? false,
  };
}

function parse(args: readonly string[]) {
  const text = { type: "string" } as const;
  const flag = { type: "boolean" } as const;
  const files = { out: text, from: text };
  const numbers = { size: text, samples: text, runs: text };
  const flags = { gpu: flag, quick: flag, help: flag };
  try {
    const options = { scenes: text, renderers: text, host: text, ...numbers, ...files, ...flags };
    return parseArgs({ args: [...args], options }).values;
  } catch (error) {
    throw new UsageError(`${(error as Error).message}\n\n${USAGE}`);
  }
}

function listOf<const T extends string>(
  option: string,
  text: string | undefined,
  choices: readonly T[],
  byDefault: readonly T[],
): readonly T[] {
  const names = text?.split(",") ?? byDefault;
  const unknown = names.find((name) => !choices.some((choice) => choice === name));
  if (unknown === undefined) return choices.filter((choice) => names.includes(choice));
  throw new UsageError(`${option}: expected some of ${choices.join(", ")}, got ${unknown}`);
}

function hostsOf(text: string): Options["hosts"] {
  if (text === "both") return ["chromium", "dawn"];
  if (text === "chromium" || text === "dawn") return [text];
  throw new UsageError(`--host: expected chromium, dawn or both, got ${text}`);
}

function integer(option: string, text: string | undefined, least: number, byDefault: number): number {
  const value = Number(text ?? byDefault);
  if (Number.isInteger(value) && value >= least) return value;
  throw new UsageError(`${option}: expected an integer ≥ ${least}, got ${text}`);
}
