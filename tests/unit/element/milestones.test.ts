import { beforeEach, expect, test, vi } from "vitest";
import { Milestones } from "../../../src/element/milestones";
import type { PathTracer } from "../../../src/renderer/pathTracer";

const told: string[] = [];
let isPaused: boolean;
let pauseWhenReady: boolean;
let milestones: Milestones;

beforeEach(() => {
  told.length = 0;
  isPaused = pauseWhenReady = false;
  milestones = new Milestones({
    onReady: () => {
      told.push("ready");
      if (pauseWhenReady) isPaused = true;
    },
    onProgress: ({ samples }) => void told.push(`progress ${samples}`),
    onConverged: ({ samples }) => void told.push(`converged ${samples}`),
    isPaused: () => isPaused,
  });
  vi.spyOn(performance, "now").mockReturnValue(0);
});

function frame(samples: number, { atMs = 0, converged = false, isFullSize = true } = {}): void {
  vi.spyOn(performance, "now").mockReturnValue(atMs);
  milestones.report({ tracer: { stats: { samples, error: 1, converged } } as PathTracer, isFullSize });
}

/** A scene is there, and its first sample on the canvas. */
function showFirst(): void {
  milestones.expectPicture(0);
  milestones.noteDrawn();
  frame(1);
}

test("a scene is ready when something was drawn that has a sample, once", () => {
  milestones.expectPicture(0);
  expect(milestones.owesPicture).toBe(true);
  frame(1);
  expect(told).toEqual([]);
  milestones.noteDrawn();
  frame(0);
  expect(told).toEqual([]);
  frame(1);
  frame(1);
  expect(told).toEqual(["ready", "progress 1"]);
  expect(milestones.owesPicture).toBe(false);
});

test("progress is told at most ten times a second", () => {
  showFirst();
  frame(2, { atMs: 50 });
  frame(3, { atMs: 100 });
  frame(4, { atMs: 199 });
  expect(told).toEqual(["ready", "progress 1", "progress 3"]);
});

test("convergence is told at once, and once", () => {
  showFirst();
  frame(8, { atMs: 1, converged: true });
  frame(8, { atMs: 200, converged: true });
  expect(told).toEqual(["ready", "progress 1", "progress 8", "converged 8"]);
});

test("a picture of fewer pixels has not converged, nor has one that is paused", () => {
  showFirst();
  frame(8, { atMs: 200, converged: true, isFullSize: false });
  isPaused = true;
  frame(8, { atMs: 400, converged: true });
  expect(told).toEqual(["ready", "progress 1", "progress 8"]);
});

test("a pause that a listener of `ready` asks for counts in the same frame", () => {
  pauseWhenReady = true;
  milestones.expectPicture(0);
  milestones.noteDrawn();
  frame(8, { converged: true });
  expect(told).toEqual(["ready", "progress 8"]);
});
