import type { Page } from "@playwright/test";

type TraceEvent = {
  readonly name: string;
  readonly ph: string;
  readonly pid: number;
  readonly tid: number;
  /** Microseconds: of the clock, and of the processor. */
  readonly dur?: number;
  readonly tdur?: number;
  readonly args?: { readonly name?: string };
};

export type Task = { readonly milliseconds: number; readonly processorMs: number };

/**
 * The tasks of a page's main thread while something goes on, longest first.
 *
 * What counts is how long the processor was at one. By the clock a task is longer where other programs want the processor too:
 * on a busy machine tens of milliseconds, whatever the task.
 */
export async function tasksDuring(page: Page, act: () => Promise<unknown>): Promise<readonly Task[]> {
  const browser = page.context().browser()!;
  await browser.startTracing(page, { categories: ["toplevel", "disabled-by-default-devtools.timeline"] });
  await act();
  const trace = JSON.parse((await browser.stopTracing()).toString()) as { traceEvents: TraceEvent[] };
  const threads = new Map<string, number[][]>();
  for (const { name, args, pid, tid } of trace.traceEvents) {
    if (name === "thread_name" && args?.name === "CrRendererMain") threads.set(`${pid} ${tid}`, []);
  }
  for (const { name, ph, pid, tid, dur = 0, tdur = 0 } of trace.traceEvents) {
    if (ph === "X" && name.endsWith("RunTask")) threads.get(`${pid} ${tid}`)?.push([dur / 1000, tdur / 1000]);
  }
  // The page's is the thread that does most: others are of pages that the browser keeps ready.
  const busiest = [...threads.values()].sort((a, b) => b.length - a.length)[0] ?? [];
  return busiest
    .map(([milliseconds, processorMs]) => ({ milliseconds: milliseconds!, processorMs: processorMs! }))
    .sort((a, b) => b.processorMs - a.processorMs);
}
