import { describe, expect, test } from "vitest";
import { ErrorChecks } from "../../../src/renderer/errorChecks";

/**
 * Runs a picture whose error is small enough from `enough` samples on, as the renderer does: `perSubmit` samples in each submit,
 * and each report known only `latency` submits later.
 *
 * @returns samples when it stops.
 */
function samplesTaken(enough: number, perSubmit: number, latency: number): number {
  const checks = new ErrorChecks();
  const reports: (number | undefined)[] = [];
  let samples = 0;
  for (let step = 0; step < 100_000; step++) {
    const allowed = checks.allowedSamples(samples, 0.01) - samples;
    if (allowed > 0) {
      samples += Math.min(perSubmit, allowed);
      reports.push(checks.ask(samples, 0.01, false, 0) ? samples : undefined);
    } else reports.push(undefined);
    const known = reports[step - latency];
    if (known === undefined) continue;
    checks.report(known);
    if (known >= enough) return samples;
  }
  throw new Error("it never stops");
}

describe("a picture with a target error", () => {
  test.each([2, 3, 10, 97, 1000, 12_345])("of %i samples stops within twice as many, on any adapter", (enough) => {
    for (const perSubmit of [1, 2, 7, 64, 2048]) {
      for (const latency of [1, 2, 5]) {
        const taken = samplesTaken(enough, perSubmit, latency);
        expect(taken).toBeGreaterThanOrEqual(enough);
        expect(taken, `${perSubmit} a submit, ${latency} late`).toBeLessThanOrEqual(Math.max(2 * enough, enough + 4));
      }
    }
  });

  test("set late goes on from where the picture is", () => {
    const checks = new ErrorChecks();
    expect(checks.ask(2, 0, false, 1000)).toBe(true);
    checks.report(2);
    expect(checks.ask(500, 0, false, 1100)).toBe(false);
    expect(checks.allowedSamples(500, 0.1)).toBe(502);
    expect(checks.ask(502, 0.1, false, 1101)).toBe(true);
  });
});

describe("a picture without one", () => {
  test("is never held up, and estimated five times a second and at its end", () => {
    const checks = new ErrorChecks();
    const asked = [];
    for (let frame = 1; frame <= 60; frame++) if (checks.ask(frame, 0, frame === 60, frame * 16.7)) asked.push(frame);
    expect(asked).toEqual([2, 14, 26, 38, 50, 60]);
    expect(checks.allowedSamples(1000, 0)).toBe(Number.POSITIVE_INFINITY);
  });
});
