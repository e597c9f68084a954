import type { Scene } from "rt-viewer";
import { element } from "../page";
import type { Adapter } from "./adapter";
import { percent } from "./format";
import type { OneAtATime } from "./oneAtATime";
import { ORIGINAL_SETTINGS } from "./originalSettings";
import { frameSize, measureFrame, type Size } from "./originalTable";
import { loadReference } from "./reference";
import type { TableResults, TableRow } from "./results";

const SCENE = "spheres";

/** The original's table on the page, filled in line by line. */
export class TableView {
  readonly #adapter: Adapter;
  readonly #stage: OneAtATime;
  readonly #report: (error: unknown) => void;
  readonly #size: Size;
  readonly #button = element<HTMLButtonElement>("#measure");
  readonly #note = element("#measuring");
  readonly #rows: TableRow[] = [...ORIGINAL_SETTINGS];
  #isRunning = false;

  /** @param report - what to do with an error that ends the measurement. */
  constructor(adapter: Adapter, stage: OneAtATime, report: (error: unknown) => void) {
    this.#adapter = adapter;
    this.#stage = stage;
    this.#report = report;
    this.#size = frameSize(adapter.isSoftware);
    const { width, height } = this.#size;
    element("#frame-size").textContent = `${width} × ${height} pixels`;
    this.#button.addEventListener("click", () => (this.#isRunning ? stage.stop() : this.run()));
    this.#button.disabled = false;
  }

  get results(): TableResults {
    return { size: this.#size, rows: this.#rows };
  }

  /** Measures what is missing; everything again if nothing is. */
  run(): void {
    this.#stage.begin((signal) => this.#run(signal).catch(this.#report));
  }

  async #run(signal: AbortSignal): Promise<void> {
    this.#isRunning = true;
    this.#button.textContent = "Stop";
    if (this.#rows.every(isComplete)) {
      this.#rows.splice(0, this.#rows.length, ...ORIGINAL_SETTINGS);
      this.#rows.forEach((_, index) => void this.#show(index));
    }
    try {
      const { scene } = await loadReference(SCENE);
      for (const index of this.#rows.keys()) {
        if (signal.aborted) break;
        if (!isComplete(this.#rows[index]!)) await this.#measure(index, scene, signal);
      }
    } finally {
      this.#isRunning = false;
      const isDone = this.#rows.every(isComplete);
      this.#button.textContent = isDone ? "Measure again" : "Continue";
      this.#note.textContent = isDone ? "All ten measured." : "";
    }
  }

  async #measure(index: number, scene: Scene, signal: AbortSignal): Promise<void> {
    const line = lineOf(index);
    this.#note.textContent = `${index + 1} of ${this.#rows.length} …`;
    line.classList.add("busy");
    try {
      for (const estimator of ["path", "uniform"] as const) {
        if (signal.aborted) return;
        const row = this.#rows[index]!;
        const frame = await measureFrame(this.#adapter.device, scene, this.#size, row, estimator);
        this.#rows[index] = { ...row, [estimator]: frame };
        this.#show(index);
      }
    } finally {
      line.classList.remove("busy");
    }
  }

  #show(index: number): void {
    const { path, uniform } = this.#rows[index]!;
    const texts: { readonly [name: string]: string } = {
      fps: path ? fpsText(path.fps) : "–",
      error: percent(path?.error),
      uniform: percent(uniform?.error),
    };
    for (const cell of lineOf(index).querySelectorAll<HTMLElement>("[data-figure]")) {
      cell.textContent = texts[cell.dataset.figure ?? ""] ?? "–";
    }
  }
}

/** Writes the original's settings and figures into the table; that takes no adapter. */
export function listSettings(): void {
  const lines = ORIGINAL_SETTINGS.map(({ rays, bounces, lightSamples, reported }) => {
    const line = document.createElement("tr");
    const setting = document.createElement("th");
    setting.scope = "row";
    setting.textContent = `${rays} / ${bounces} / ${lightSamples}`;
    line.append(setting, cell(reported), cell("–", "fps"), cell("–", "error"), cell("–", "uniform"));
    return line;
  });
  element("#settings tbody").replaceChildren(...lines);
}

function cell(text: string, figure?: string): HTMLTableCellElement {
  const made = document.createElement("td");
  made.textContent = text;
  if (figure) made.dataset.figure = figure;
  return made;
}

function lineOf(index: number): HTMLElement {
  return element(`#settings tbody tr:nth-child(${index + 1})`);
}

function isComplete({ path, uniform }: TableRow): boolean {
  return path !== undefined && uniform !== undefined;
}

function fpsText(fps: number): string {
  return fps < 10 ? fps.toFixed(fps < 1 ? 2 : 1) : fps.toFixed(0);
}
