import { element } from "../page";
import type { Adapter } from "./adapter";
import { count, duration, percent, shortNumber, times } from "./format";
import type { OneAtATime } from "./oneAtATime";
import { type Curve, Plot } from "./plot";
import { ESTIMATORS, type Estimator, type Lane, LIMIT_S, Race } from "./race";
import { loadReference, type Reference } from "./reference";
import { speedOf } from "./results";
import { efficiency, type Lead, lastKnown, leadOf } from "./statistics";

const LABELS = {
  path: { label: "rt-viewer", shortLabel: "rt-viewer" },
  uniform: { label: "Uniform baseline", shortLabel: "Baseline" },
} as const satisfies Record<Estimator, Omit<Curve, "key" | "points">>;

/** In stops; as in the gallery. */
const EXPOSURES: { readonly [scene: string]: number } = { bleed: 1.5, veach: 1 };

type State = "idle" | "running" | "stopped" | "over";

const BUTTON: Record<State, string> = { idle: "Run", running: "Stop", stopped: "Continue", over: "Run again" };

/** The race on the page: its controls, pictures, plot and figures. */
export class RaceView {
  readonly #adapter: Adapter;
  readonly #stage: OneAtATime;
  readonly #report: (error: unknown) => void;
  readonly #button = element<HTMLButtonElement>("#run");
  readonly #scenes = element<HTMLFieldSetElement>("#scenes");
  readonly #plot = new Plot(element("#plot"));
  readonly #contexts: Record<Estimator, GPUCanvasContext>;
  readonly #references = new Map<string, Promise<Reference>>();
  #race: Race | undefined;
  #lead: Lead | undefined;
  #state: State = "idle";

  /** @param report - what to do with an error that ends a race. */
  constructor(adapter: Adapter, stage: OneAtATime, report: (error: unknown) => void) {
    this.#adapter = adapter;
    this.#stage = stage;
    this.#report = report;
    this.#contexts = { path: this.#context("path"), uniform: this.#context("uniform") };
    this.#button.addEventListener("click", () => (this.#state === "running" ? stage.stop() : this.run()));
    this.#scenes.addEventListener("change", () => this.run());
    for (const control of [this.#button, this.#scenes]) control.disabled = false;
    this.#show();
  }

  /** What there is to copy. */
  get results(): { readonly race: Race; readonly lead: Lead | undefined } | undefined {
    return this.#race && { race: this.#race, lead: this.#lead };
  }

  /** Goes on with the race; starts one if there is none, it is over, or another scene is wanted. */
  run(): void {
    this.#stage.begin((signal) => this.#run(signal).catch(this.#report));
  }

  async #run(signal: AbortSignal): Promise<void> {
    this.#enter("running");
    try {
      const race = await this.#prepare();
      await race.run(signal, (lane, isPoint) => {
        this.#present(lane);
        if (isPoint) this.#show();
        else this.#showFigures(lane);
      });
      race.lanes.forEach((lane) => void this.#present(lane));
    } finally {
      this.#enter(this.#race?.isOver ? "over" : "stopped");
    }
  }

  async #prepare(): Promise<Race> {
    const name = element<HTMLInputElement>("input:checked", this.#scenes).value;
    if (this.#race && !this.#race.isOver && this.#race.reference.name === name) return this.#race;
    this.#race?.dispose();
    this.#race = undefined;
    this.#show();
    const race = await Race.create(this.#adapter.device, await this.#reference(name));
    this.#race = race;
    const title = element(`input[value="${name}"] + span`, this.#scenes).textContent;
    for (const key of ESTIMATORS) {
      element(`canvas.${key}`).setAttribute("aria-label", `${title}, rendered by ${LABELS[key].label}`);
    }
    return race;
  }

  #reference(name: string): Promise<Reference> {
    const known = this.#references.get(name) ?? loadReference(name);
    this.#references.set(name, known);
    known.catch(() => this.#references.delete(name));
    return known;
  }

  #context(estimator: Estimator): GPUCanvasContext {
    const context = element<HTMLCanvasElement>(`canvas.${estimator}`).getContext("webgpu")!;
    context.configure({ device: this.#adapter.device, format: navigator.gpu.getPreferredCanvasFormat() });
    return context;
  }

  #present({ estimator, tracer }: Lane): void {
    const exposure = EXPOSURES[this.#race?.reference.name ?? ""] ?? 0;
    tracer.present(this.#contexts[estimator], { exposure });
  }

  #enter(state: State): void {
    this.#state = state;
    this.#button.textContent = BUTTON[state];
    const verdict = element("#verdict").textContent?.trim();
    if (state === "over") element("#announcement").textContent = `The race is over. ${verdict}`;
    if (state === "stopped") element("#announcement").textContent = `The race rests. ${verdict}`;
  }

  #show(): void {
    const lanes = this.#race?.lanes ?? [];
    const [ours = [], theirs = []] = ESTIMATORS.map((name) => lanes.find((lane) => lane.estimator === name)?.points);
    const lead = leadOf(ours, theirs);
    this.#lead = lead !== undefined && lead.factor >= 1 ? lead : undefined;
    this.#plot.show({
      curves: ESTIMATORS.map((key, index) => ({ key, ...LABELS[key], points: [ours, theirs][index]! })),
      ownError: this.#race?.reference.ownError ?? 0,
      limit: LIMIT_S,
      lead: this.#lead,
    });
    showVerdict(this.#lead, leadOf(theirs, ours));
    for (const estimator of ESTIMATORS) {
      const lane = lanes.find((candidate) => candidate.estimator === estimator);
      if (lane) this.#showFigures(lane);
      else for (const cell of cellsOf(estimator)) cell.textContent = "–";
    }
  }

  #showFigures(lane: Lane): void {
    const { tracer, points, seconds, estimator } = lane;
    const known = lastKnown(points);
    const newest = points.at(-1);
    const isTooGood = newest !== undefined && newest.trueError === undefined;
    const { pathsPerSecond = Number.NaN, raysPerSecond = Number.NaN } = speedOf(lane);
    const figures: { readonly [name: string]: string } = {
      samples: count(tracer.stats.samples),
      seconds: duration(seconds),
      paths: millions(pathsPerSecond),
      rays: millions(raysPerSecond),
      truth: isTooGood ? `< ${percent(this.#race?.reference.ownError)}` : percent(newest?.trueError),
      estimate: percent(newest?.estimatedError),
      efficiency: known ? shortNumber(efficiency(known)) : "–",
    };
    for (const cell of cellsOf(estimator)) cell.textContent = figures[cell.dataset.figure ?? ""] ?? "–";
    const spent = this.#race?.lanes.reduce((sum, other) => sum + Math.min(other.seconds, LIMIT_S), 0) ?? 0;
    element<HTMLProgressElement>("#progress").value = spent / (ESTIMATORS.length * LIMIT_S);
  }
}

function cellsOf(estimator: Estimator): Iterable<HTMLElement> {
  return document.querySelectorAll<HTMLElement>(`[data-lane="${estimator}"]`);
}

function millions(perSecond: number): string {
  return Number.isFinite(perSecond) ? (perSecond / 1e6).toPrecision(3) : "–";
}

function showVerdict(ahead: Lead | undefined, behind: Lead | undefined): void {
  const lead = ahead ?? behind;
  const [subject, object] = ahead || !behind ? ["rt-viewer", "the baseline’s"] : ["The baseline", "rt-viewer’s"];
  element("#verdict-before").textContent = `${subject} reaches ${object} error`;
  element("#verdict-times").textContent = lead ? `${lead.isAtLeast ? "≥ " : ""}${times(lead.factor)}` : "…×";
  element("#verdict-detail").textContent = lead
    ? `${percent(lead.error)} after ${duration(lead.sooner)} instead of ${duration(lead.later)}`
    : "both have just begun";
}
