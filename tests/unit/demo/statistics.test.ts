import { expect, test } from "vitest";
import type { Reference } from "../../../demo/performance/reference";
import {
  efficiency,
  errorOfPair,
  leadOf,
  type Point,
  timeToReach,
  trueError,
} from "../../../demo/performance/statistics";

/** One pixel of radiance 2 whose three values are each known to ±0.1. */
const reference: Reference = {
  name: "one pixel",
  scene: { camera: { position: [0, 0, 1] }, objects: [] },
  width: 1,
  height: 1,
  image: new Float32Array([2, 2, 2]),
  samples: 1,
  mean: 2,
  meanSquaredNoise: 0.01,
  ownError: 0.05,
};

const point = (seconds: number, error: number | undefined): Point => ({
  samples: 1,
  seconds,
  trueError: error,
  estimatedError: error,
});

test("the true error leaves alpha and the reference's own noise out", () => {
  // Differences of 0.5: sqrt(0.25 − 0.01)/2.
  expect(trueError([2.5, 1.5, 2.5, 1], reference)).toBeCloseTo(Math.sqrt(0.24) / 2, 12);
});

test("there is no true error where the reference is the noisier one", () => {
  expect(trueError([2, 2, 2, 1], reference)).toBeUndefined();
  expect(trueError([2.11, 2.11, 2.11, 1], reference)).toBeUndefined();
});

test("two pictures tell the error of one", () => {
  // They differ by 2, so that each has a variance of 2²/2; their mean is 2.
  expect(errorOfPair([1, 1, 1, 1], [3, 3, 3, 1])).toBeCloseTo(Math.sqrt(2) / 2, 12);
});

test("a curve is read off along straight lines of the log-log plot", () => {
  const curve = [point(1, 0.4), point(4, 0.2), point(16, 0.1)];
  expect(timeToReach(0.2, curve)?.seconds).toBeCloseTo(4, 12);
  expect(timeToReach(Math.sqrt(0.2 * 0.1), curve)?.seconds).toBeCloseTo(8, 12);
  expect(timeToReach(0.05, curve)).toBeUndefined();
});

test("a curve that begins below an error has reached it by its beginning at the latest", () => {
  expect(timeToReach(0.5, [point(1, 0.4), point(4, 0.2)])).toEqual({ seconds: 1, isLatest: true });
});

test("with errors that fall as they should, the lead is the ratio of the efficiencies", () => {
  const curve = (scale: number) => [1, 4, 16, 64].map((seconds) => point(seconds, scale / Math.sqrt(seconds)));
  const [ours, theirs] = [curve(1), curve(3)];
  const last = { ...point(1, 0), trueError: 0 };
  const ratio =
    efficiency({ ...last, ...ours[3]!, trueError: 1 / 8 }) / efficiency({ ...last, ...theirs[3]!, trueError: 3 / 8 });
  expect(ratio).toBeCloseTo(9, 12);
  expect(leadOf(ours, theirs)?.factor).toBeCloseTo(ratio, 12);
  expect(leadOf(theirs, ours)).toBeUndefined();
});

test("the lead is taken where the slower curve was lowest, not where it has risen to", () => {
  const lead = leadOf([point(1, 0.5), point(2, 0.1)], [point(3, 2), point(4, 0.5), point(8, 4)]);
  expect(lead).toMatchObject({ error: 0.5, sooner: 1, later: 4, factor: 4 });
});

test("points below the reference's noise are passed over", () => {
  expect(leadOf([point(1, 0.1), point(2, undefined)], [point(5, 0.1), point(6, undefined)])?.factor).toBeCloseTo(5, 12);
});
