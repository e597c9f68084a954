import type { Adapter } from "./adapter";
import type { OriginalSetting } from "./originalSettings";
import type { Frame, Size } from "./originalTable";
import { type Lane, LIMIT_S, type Race } from "./race";
import { efficiency, type Lead, lastKnown } from "./statistics";

/** What one line of the original's table came to; what has not been measured is missing. */
export type TableRow = OriginalSetting & { readonly path?: Frame; readonly uniform?: Frame };

export type TableResults = { readonly size: Size; readonly rows: readonly TableRow[] };

/** Everything measured on this page, as readable JSON. Errors are relative RMSEs, times seconds. */
export function resultsText(
  adapter: Adapter,
  race: { readonly race: Race; readonly lead: Lead | undefined } | undefined,
  table: TableResults,
): string {
  const results = {
    what: "rt-viewer: error against time",
    page: location.href,
    date: new Date().toISOString(),
    adapter: adapter.name,
    softwareAdapter: adapter.isSoftware,
    userAgent: navigator.userAgent,
    race: race && {
      scene: race.race.reference.name,
      width: race.race.reference.width,
      height: race.race.reference.height,
      reference: `Mitsuba 3, ${race.race.reference.samples} samples per pixel`,
      referenceOwnError: rounded(race.race.reference.ownError),
      limitSeconds: LIMIT_S,
      soonerBy: race.lead && { factor: rounded(race.lead.factor), atError: rounded(race.lead.error) },
      estimators: Object.fromEntries(race.race.lanes.map((lane) => [lane.estimator, laneResults(lane)])),
    },
    table: {
      scene: "spheres",
      ...table.size,
      rows: table.rows.map(({ rays, bounces, lightSamples, reported, path, uniform }) => ({
        raysPerPixel: rays,
        bounces,
        lightSamples,
        originalFps: reported,
        fps: path && rounded(path.fps),
        error: path && rounded(path.error),
        uniformFps: uniform && rounded(uniform.fps),
        uniformError: uniform && rounded(uniform.error),
      })),
    },
  };
  // A point or a row takes a line, not six.
  return JSON.stringify(results, undefined, 2).replaceAll(/\{[^{}[\]]*\}/g, (flat) =>
    flat.length < 320 ? flat.replaceAll(/\s*\n\s*/g, " ") : flat,
  );
}

function laneResults({ tracer, seconds, points }: Lane) {
  const end = lastKnown(points);
  return {
    samples: tracer.stats.samples,
    seconds: rounded(seconds),
    ...speedOf({ tracer, seconds }),
    efficiency: end && rounded(efficiency(end)),
    points: points.map((point) => ({
      samples: point.samples,
      seconds: rounded(point.seconds),
      trueError: point.trueError === undefined ? null : rounded(point.trueError),
      estimatedError: point.estimatedError === undefined ? null : rounded(point.estimatedError),
    })),
  };
}

/** Paths and rays per second of an estimator's own time. */
export function speedOf({ tracer, seconds }: Pick<Lane, "tracer" | "seconds">): {
  readonly pathsPerSecond: number | undefined;
  readonly raysPerSecond: number | undefined;
} {
  const { samples, pathsPerSecond, raysPerSecond } = tracer.stats;
  if (seconds === 0 || pathsPerSecond === 0) return { pathsPerSecond: undefined, raysPerSecond: undefined };
  const paths = (samples * tracer.width * tracer.height) / seconds;
  return { pathsPerSecond: Math.round(paths), raysPerSecond: Math.round((paths * raysPerSecond) / pathsPerSecond) };
}

function rounded(value: number): number {
  return Number(value.toPrecision(4));
}
