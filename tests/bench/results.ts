import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname } from "node:path";
import type { RendererId, SceneName } from "./options";
import type { ExcessFigure, NoiseFigure } from "./statistics";

/** All that one run of the benchmark measured, as it is kept in `results/`. */
export type Results = {
  readonly machine: Machine;
  readonly protocol: {
    /** Pixels per side. */
    readonly size: number;
    readonly samples: number;
    readonly runs: number;
  };
  readonly rows: readonly Row[];
  readonly notMeasured: readonly NotMeasured[];
  readonly estimates: readonly EstimateRow[];
  readonly frames: readonly FrameRow[];
};

export type Machine = {
  readonly cpu: string;
  readonly cores: number;
  readonly system: string;
  readonly node: string;
  readonly chromium?: string;
  /** YYYY-MM-DD. */
  readonly date: string;
};

/** What a renderer is, and where it ran. */
export type Entrant = {
  readonly id: RendererId;
  readonly renderer: string;
  readonly host: "Chromium" | "Dawn in Node" | "Python";
  readonly adapter: string;
};

/** One renderer, one scene, one sample count. */
export type Row = Entrant &
  NoiseFigure & {
    readonly scene: SceneName;
    readonly samples: number;
    /** Whether this is the count of the tables; the others are for the plots. */
    readonly isMain: boolean;
    /** Of every run. */
    readonly seconds: readonly number[];
    /** The first time. */
    readonly setupSeconds: number;
    /** Where the size fits the reference. */
    readonly bias?: ExcessFigure;
  };

export type NotMeasured = { readonly id: RendererId; readonly scene?: SceneName; readonly reason: string };

/** The viewer's estimate of its error against the truth. */
export type EstimateRow = {
  readonly scene: SceneName;
  readonly sampler: "sobol" | "independent";
  readonly samples: number;
  readonly estimate: number;
  readonly truth: number;
};

/** A row of the original's table. */
export type FrameRow = NoiseFigure & {
  readonly host: Entrant["host"];
  readonly adapter: string;
  readonly estimator: "path" | "uniform";
  readonly rays: number;
  readonly bounces: number;
  readonly lightSamples: number;
  readonly width: number;
  readonly height: number;
  /** Of every frame. */
  readonly seconds: readonly number[];
};

export function readResults(file: string): Results {
  return JSON.parse(readFileSync(file, "utf8")) as Results;
}

export function writeFile(file: string, text: string): void {
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, text);
}

// Adapters that are programs, by what they or the layers around them call them.
const SOFTWARE = ["SwiftShader", "llvmpipe", "lavapipe", "softpipe", "Microsoft Basic Render Driver"];

function softwareNameOf(adapter: string): string | undefined {
  return SOFTWARE.find((name) => adapter.toLowerCase().includes(name.toLowerCase()));
}

/** An adapter's name for readers: one that is software says so, whatever it calls itself. */
export function adapterLabel(adapter: string): string {
  const software = softwareNameOf(adapter);
  return software === undefined ? adapter : `${software} (software, no GPU)`;
}

/** How a host and its adapter appear in tables and plots. */
export function placeOf({ host, adapter }: Pick<Entrant, "host" | "adapter">): string {
  return host === "Python" ? adapterLabel(adapter) : `${host}, ${adapterLabel(adapter)}`;
}

/** For a file's name. */
export function slugOf(adapter: string): string {
  return (softwareNameOf(adapter) ?? adapter)
    .toLowerCase()
    .replaceAll(/[^a-z0-9]+/g, "-")
    .replaceAll(/^-|-$/g, "");
}
