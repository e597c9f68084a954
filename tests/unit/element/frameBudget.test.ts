import { describe, expect, it } from "vitest";
import { affordableSize, FrameBudget } from "../../../src/element/frameBudget";

const FULL = { width: 800, height: 600 };
const PIXELS = 800 * 600;
const FRAME_MS = 1000 / 60;
/** Paths per second at which one sample of all pixels of `FULL` takes so many milliseconds. */
const paceFor = (ms: number) => (1000 * PIXELS) / ms;

describe("affordableSize", () => {
  it("leaves a picture alone that fits a frame", () => {
    expect(affordableSize(FULL, FULL, paceFor(10))).toEqual(FULL);
    expect(affordableSize(FULL, FULL, paceFor(0.1))).toEqual(FULL);
  });

  it.each([15, 50, 200])("shrinks one that takes %d ms to what fits a frame, in its proportions", (ms) => {
    const { width, height } = affordableSize(FULL, FULL, paceFor(ms));
    const passMs = (width * height * ms) / PIXELS;
    expect(passMs).toBeGreaterThan(0.4 * FRAME_MS);
    expect(passMs).toBeLessThan(0.6 * FRAME_MS);
    expect(Math.abs(width - (height * 800) / 600)).toBeLessThanOrEqual(0.5);
  });

  it("never goes below an eighth of each side, nor 64 pixels of the shorter one", () => {
    expect(affordableSize({ width: 1600, height: 1200 }, FULL, 1)).toMatchObject({
      width: 200,
      height: 150,
    });
    expect(affordableSize(FULL, FULL, 1)).toMatchObject({ width: 100, height: 75 });
    expect(affordableSize({ width: 300, height: 150 }, FULL, 1)).toMatchObject({ width: 128, height: 64 });
    expect(affordableSize({ width: 50, height: 40 }, FULL, 1)).toMatchObject({ width: 50, height: 40 });
    expect(affordableSize({ width: 1, height: 1 }, FULL, 1)).toMatchObject({ width: 1, height: 1 });
  });

  it("keeps a film while the pace is off by less than a quarter, and not when it is off by half", () => {
    const film = affordableSize(FULL, FULL, paceFor(100));
    for (const ms of [80, 90, 110, 125]) expect(affordableSize(FULL, film, paceFor(ms))).toEqual(film);
    expect(affordableSize(FULL, film, paceFor(150)).width).toBeLessThan(film.width);
    expect(affordableSize(FULL, film, paceFor(50)).width).toBeGreaterThan(film.width);
  });

  it("settles at once: what it chose, it keeps", () => {
    for (let ms = 1; ms < 5000; ms *= 1.1) {
      const film = affordableSize(FULL, FULL, paceFor(ms));
      expect(affordableSize(FULL, film, paceFor(ms))).toEqual(film);
    }
  });

  it("follows the proportions of a picture that changes them", () => {
    const film = affordableSize(FULL, FULL, paceFor(100));
    const { width, height } = affordableSize({ width: 600, height: 600 }, film, paceFor(100));
    expect(width).toBe(height);
  });
});

describe("FrameBudget", () => {
  const slow = paceFor(200);

  it("renders everything for a single change", () => {
    const budget = new FrameBudget();
    expect(budget.sizeFor(FULL, FULL, slow, 0)).toEqual(FULL);
    budget.noteChange(1000);
    expect(budget.sizeFor(FULL, FULL, slow, 1000)).toEqual(FULL);
    budget.noteChange(1500);
    expect(budget.sizeFor(FULL, FULL, slow, 1500)).toEqual(FULL);
  });

  it("renders less from the second change in a row until a fifth of a second after the last", () => {
    const budget = new FrameBudget();
    for (const now of [1000, 1016, 1033, 1190]) budget.noteChange(now);
    const film = budget.sizeFor(FULL, FULL, slow, 1190);
    expect(film.width).toBeLessThan(400);
    expect(budget.sizeFor(FULL, film, slow, 1380)).toEqual(film);
    expect(budget.sizeFor(FULL, film, slow, 1400)).toEqual(FULL);
  });

  it("renders everything while nothing is known of the adapter", () => {
    const budget = new FrameBudget();
    for (const now of [1000, 1016]) budget.noteChange(now);
    expect(budget.sizeFor(FULL, FULL, 0, 1016)).toEqual(FULL);
  });
});
