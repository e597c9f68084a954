import { type LoadPhase, RtViewerElement } from "../../../src/element";
import { meshFile } from "../../support/gltf";
import { bumpySphere } from "../../support/meshes";
import { type DropPhase, phasesOf, watchDrop } from "./dropMarks";

/** What a page went through from the moment a file was dropped to its first picture. */
export type MeasuredDrop = {
  readonly triangles: number;
  /** Of the file. */
  readonly bytes: number;
  readonly adapter: string;
  /** All phases together. */
  readonly milliseconds: number;
  readonly phases: Readonly<Record<DropPhase, number>>;
  /** What kept the page's thread for more than 50 ms, and when; longest first. */
  readonly longTasks: readonly { readonly milliseconds: number; readonly phase: DropPhase }[];
  /** Between two frames of the page. */
  readonly longestFrame: number;
  /** `loadprogress` events of each kind. */
  readonly events: Readonly<Record<LoadPhase, number>>;
  /** What the bar showed, frame by frame, repetitions left out: percentages, `-` where it only shows that something goes on. */
  readonly bar: readonly string[];
};

const SIDE = 256;
// Until garbage has been collected and code of the page compiled.
const SETTLING_MS = 1000;
// The browser tells of long tasks a while after them.
const NOTICE_MS = 200;

/**
 * Drops a .glb file with a bumpy sphere onto an empty viewer of 256 × 256. The page must be fresh: code is loaded and a GPU
 * is asked for as by whoever drops the first file.
 *
 * @param triangles - about as many, more than are sorted in the page's thread.
 */
export async function measureDrop(triangles: number): Promise<MeasuredDrop> {
  const sphere = bumpySphere(triangles);
  const file = new File([meshFile(sphere) as Uint8Array<ArrayBuffer>], "bumpy.glb");
  const viewer = await openViewer();
  await sleep(SETTLING_MS);

  const tasks = watchLongTasks();
  const frames = watchFrames(viewer);
  const events: Record<LoadPhase, number> = { fetching: 0, building: 0, compiling: 0 };
  viewer.addEventListener("loadprogress", ({ detail }) => {
    events[detail.phase] += 1;
  });
  const marks = watchDrop(viewer);
  const shown = new Promise<string>((resolve, reject) => {
    viewer.addEventListener("ready", ({ detail }) => resolve(detail.tracer.stats.adapter));
    viewer.addEventListener("error", ({ detail }) => reject(detail.error));
  });
  const droppedAt = performance.now();
  drop(viewer, file);
  const adapter = await shown;
  await sleep(NOTICE_MS);

  const phases = phasesOf(droppedAt, marks);
  return {
    triangles: sphere.indices.length / 3,
    bytes: file.size,
    adapter,
    milliseconds: marks.shown! - droppedAt,
    phases,
    longTasks: tasks().flatMap(({ startTime, duration }) => {
      const phase = phaseAt(startTime + duration / 2 - droppedAt, phases);
      return phase === undefined ? [] : [{ milliseconds: duration, phase }];
    }),
    ...frames(marks.shown!),
    events,
  };
}

async function openViewer(): Promise<RtViewerElement> {
  const viewer = new RtViewerElement();
  viewer.style.cssText = `width: ${SIDE}px; height: ${SIDE}px`;
  viewer.drop = true;
  document.body.append(viewer);
  while (viewer.shadowRoot!.querySelector("[part=drop]") === null) await nextFrame(); // its code is loaded on demand
  return viewer;
}

function drop(viewer: RtViewerElement, file: File): void {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(file);
  viewer.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
}

/** @returns what there was, longest first. */
function watchLongTasks(): () => readonly PerformanceEntry[] {
  const entries: PerformanceEntry[] = [];
  const observer = new PerformanceObserver((list) => void entries.push(...list.getEntries()));
  observer.observe({ type: "longtask" });
  return () => entries.toSorted((a, b) => b.duration - a.duration);
}

/** @returns what there was until a moment. */
function watchFrames(viewer: RtViewerElement): (endMs: number) => Pick<MeasuredDrop, "longestFrame" | "bar"> {
  const frames: { at: number; text: string }[] = [];
  const bar = viewer.shadowRoot!.querySelector<HTMLElement>("[part=progress]")!;
  const note = () => {
    frames.push({ at: performance.now(), text: bar.hidden ? "" : (bar.ariaValueNow ?? "-") });
    requestAnimationFrame(note);
  };
  note();
  return (endMs) => {
    const own = frames.filter(({ at }) => at <= endMs);
    const gaps = own.slice(1).map(({ at }, i) => at - own[i]!.at);
    const texts = own.map(({ text }) => text);
    return {
      longestFrame: Math.max(...gaps),
      bar: texts.filter((text, i) => text !== "" && text !== texts[i - 1]),
    };
  };
}

/** @param ms - since the drop. */
function phaseAt(ms: number, phases: Readonly<Record<DropPhase, number>>): DropPhase | undefined {
  if (ms < 0) return undefined;
  let end = 0;
  for (const [phase, milliseconds] of Object.entries(phases) as [DropPhase, number][]) {
    end += milliseconds;
    if (ms < end) return phase;
  }
  return undefined;
}

function nextFrame(): Promise<number> {
  return new Promise(requestAnimationFrame);
}

function sleep(ms: number): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, ms));
}
