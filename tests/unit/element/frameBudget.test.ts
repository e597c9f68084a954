import { describe, expect, it } from "vitest";
import { affordablePass, FrameBudget } from "../../../src/element/frameBudget";

const FULL = { width: 800, height: 600, samples: 1 };
const PIXELS = 800 * 600;
const FRAME_MS = 1000 / 60;
/** Paths per second at which one sample of all pixels of `FULL` takes so many milliseconds. */
const paceFor = (ms: number) => (1000 * PIXELS) / ms;

describe("affordablePass", () => {
  it("leaves a picture alone that fits a frame", () => {
    expect(affordablePass(FULL, FULL, paceFor(10))).toEqual(FULL);
    expect(affordablePass(FULL, FULL, paceFor(0.1))).toEqual(FULL);
  });

  it.each([15, 50, 200])("shrinks one that takes %d ms to what fits a frame, in its proportions", (ms) => {
    const { width, height, samples } = affordablePass(FULL, FULL, paceFor(ms));
    const passMs = (width * height * ms) / PIXELS;
    expect(passMs).toBeGreaterThan(0.4 * FRAME_MS);
    expect(passMs).toBeLessThan(0.6 * FRAME_MS);
    expect(Math.abs(width - (height * 800) / 600)).toBeLessThanOrEqual(0.5);
    expect(samples).toBe(1);
  });

  it("never goes below an eighth of each side, nor 64 pixels of the shorter one", () => {
    expect(affordablePass({ width: 1600, height: 1200, samples: 1 }, FULL, 1)).toMatchObject({
      width: 200,
      height: 150,
    });
    expect(affordablePass(FULL, FULL, 1)).toMatchObject({ width: 100, height: 75 });
    expect(affordablePass({ width: 300, height: 150, samples: 1 }, FULL, 1)).toMatchObject({ width: 128, height: 64 });
    expect(affordablePass({ width: 50, height: 40, samples: 1 }, FULL, 1)).toMatchObject({ width: 50, height: 40 });
    expect(affordablePass({ width: 1, height: 1, samples: 1 }, FULL, 1)).toMatchObject({ width: 1, height: 1 });
  });

  it("keeps a film while the pace is off by less than a quarter, and not when it is off by half", () => {
    const film = affordablePass(FULL, FULL, paceFor(100));
    for (const ms of [80, 90, 110, 125]) expect(affordablePass(FULL, film, paceFor(ms))).toEqual(film);
    expect(affordablePass(FULL, film, paceFor(150)).width).toBeLessThan(film.width);
    expect(affordablePass(FULL, film, paceFor(50)).width).toBeGreaterThan(film.width);
  });

  it("settles at once: what it chose, it keeps", () => {
    for (let ms = 1; ms < 5000; ms *= 1.1) {
      const film = affordablePass(FULL, FULL, paceFor(ms));
      expect(affordablePass(FULL, film, paceFor(ms))).toEqual(film);
    }
  });

  it("follows the proportions of a picture that changes them", () => {
    const film = affordablePass(FULL, FULL, paceFor(100));
    const { width, height } = affordablePass({ width: 600, height: 600, samples: 1 }, film, paceFor(100));
    expect(width).toBe(height);
  });

  it("saves on samples before it saves on pixels", () => {
    const full = { ...FULL, samples: 16 };
    expect(affordablePass(full, FULL, paceFor(2))).toEqual({ ...FULL, samples: 5 });
    expect(affordablePass(full, FULL, paceFor(10))).toEqual({ ...FULL, samples: 1 });
    expect(affordablePass(full, FULL, paceFor(0.01))).toEqual(full);
  });
});

describe("FrameBudget", () => {
  const slow = paceFor(200);

  it("renders everything for a single change", () => {
    const budget = new FrameBudget();
    expect(budget.passFor(FULL, FULL, slow, 0)).toEqual(FULL);
    budget.noteChange(1000);
    expect(budget.passFor(FULL, FULL, slow, 1000)).toEqual(FULL);
    budget.noteChange(1500);
    expect(budget.passFor(FULL, FULL, slow, 1500)).toEqual(FULL);
  });

  it("renders less from the second change in a row until a fifth of a second after the last", () => {
    const budget = new FrameBudget();
    for (const now of [1000, 1016, 1033, 1190]) budget.noteChange(now);
    const film = budget.passFor(FULL, FULL, slow, 1190);
    expect(film.width).toBeLessThan(400);
    expect(budget.passFor(FULL, film, slow, 1380)).toEqual(film);
    expect(budget.passFor(FULL, film, slow, 1400)).toEqual(FULL);
  });

  it("renders everything while nothing is known of the adapter", () => {
    const budget = new FrameBudget();
    for (const now of [1000, 1016]) budget.noteChange(now);
    expect(budget.passFor(FULL, FULL, 0, 1016)).toEqual(FULL);
  });
});
