import { PathTracer } from "rt-viewer";
import { advance, warmUp } from "./advance";
import type { Reference } from "./reference";
import { type Point, trueError } from "./statistics";

/** Each estimator gets this many seconds of its own time. */
export const LIMIT_S = 20;

// Seconds of one turn: long against what changing over costs, short enough that both pictures seem to move at once.
const TURN_S = 0.15;

export const ESTIMATORS = ["path", "uniform"] as const;
export type Estimator = (typeof ESTIMATORS)[number];

/** One estimator's part of a race. */
export type Lane = {
  readonly estimator: Estimator;
  readonly tracer: PathTracer;
  readonly points: Point[];
  /** On its own clock, which runs in its own turns only. */
  seconds: number;
  /** The next point of the curve is taken at this many samples, or when the time is up. */
  nextPoint: number;
};

/** Two estimators render the same scene on the same device, in turns of equal time. */
export class Race {
  readonly reference: Reference;
  readonly lanes: readonly Lane[];

  static async create(device: GPUDevice, reference: Reference): Promise<Race> {
    const { scene, width, height } = reference;
    const lanes: Lane[] = [];
    try {
      for (const estimator of ESTIMATORS) {
        const tracer = await PathTracer.create({ device, scene, width, height, settings: { estimator } });
        lanes.push({ estimator, tracer, points: [], seconds: 0, nextPoint: 1 });
        await warmUp(tracer);
      }
    } catch (error) {
      for (const { tracer } of lanes) tracer.dispose();
      throw error;
    }
    return new Race(reference, lanes);
  }

  private constructor(reference: Reference, lanes: readonly Lane[]) {
    this.reference = reference;
    this.lanes = lanes;
  }

  get isOver(): boolean {
    return this.lanes.every(({ seconds }) => seconds >= LIMIT_S);
  }

  /**
   * Races until everyone's time is up or `signal` stops it. Can be called again to go on.
   *
   * @param onTurn - called after each turn; `isPoint` if it ended with a new point of the curve.
   */
  async run(signal: AbortSignal, onTurn: (lane: Lane, isPoint: boolean) => void): Promise<void> {
    while (!signal.aborted && !this.isOver) {
      const lane = this.lanes.reduce((a, b) => (b.seconds < a.seconds ? b : a));
      const isPoint = await this.#takeTurn(lane);
      onTurn(lane, isPoint);
    }
  }

  dispose(): void {
    for (const { tracer } of this.lanes) tracer.dispose();
  }

  async #takeTurn(lane: Lane): Promise<boolean> {
    const { tracer } = lane;
    const { samples } = tracer.stats;
    const perSecond = lane.seconds > 0 ? samples / lane.seconds : 0;
    // An even number fills both halves of the film equally.
    const affordable = samples + 2 * Math.max(1, Math.round((perSecond * TURN_S) / 2));
    const target = Math.min(lane.nextPoint, affordable);
    lane.seconds += await advance(tracer, target);
    if (target < lane.nextPoint && lane.seconds < LIMIT_S) return false;
    await this.#addPoint(lane);
    if (target === lane.nextPoint) lane.nextPoint = pointAfter(target);
    return true;
  }

  /** Off the clock. */
  async #addPoint({ tracer, seconds, points }: Lane): Promise<void> {
    const { samples, error } = tracer.stats;
    points.push({
      samples,
      seconds,
      trueError: trueError(await tracer.readRadiance(), this.reference),
      estimatedError: Number.isFinite(error) ? error : undefined,
    });
  }
}

/** 1, 2, 4, 6, 8, 12, 16, 24, …: powers of two and what lies halfway. */
export function pointAfter(samples: number): number {
  if (samples < 4) return samples * 2;
  return Number.isInteger(Math.log2(samples)) ? samples * 1.5 : (samples * 4) / 3;
}
