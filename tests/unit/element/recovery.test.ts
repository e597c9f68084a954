import { afterEach, beforeEach, expect, test, vi } from "vitest";

/** A module of its own for each test: it remembers the page's losses. */
let Recovery: typeof import("../../../src/element/recovery").Recovery;

beforeEach(async () => {
  vi.resetModules();
  vi.useFakeTimers();
  ({ Recovery } = await import("../../../src/element/recovery"));
});
afterEach(() => void vi.useRealTimers());

const PICTURE_MS = 100; // from the device to the first picture

/** A page of viewers on one device. A killer's scene brings it down so long after its first picture, in milliseconds. */
class Page {
  readonly viewers: Viewer[] = [];
  device = {} as GPUDevice;
  losses = 0;

  add(killsAfterMs?: number): Viewer {
    const viewer = new Viewer(this, killsAfterMs);
    this.viewers.push(viewer);
    void viewer.show();
    return viewer;
  }

  lose(): void {
    const [device, victims] = [this.device, this.viewers.filter(({ isShown }) => isShown)];
    this.losses += 1;
    this.device = {} as GPUDevice;
    for (const viewer of victims) viewer.onLoss(device);
  }
}

class Viewer {
  readonly recovery = new Recovery();
  readonly shownAt: number[] = [];
  isShown = false;
  readonly #page: Page;
  readonly #killsAfterMs: number | undefined;
  #timers: ReturnType<typeof setTimeout>[] = [];
  readonly #controller = new AbortController();

  constructor(page: Page, killsAfterMs?: number) {
    this.#page = page;
    this.#killsAfterMs = killsAfterMs;
  }

  async show(): Promise<void> {
    await this.recovery.begin(this.#controller.signal);
    if (this.#controller.signal.aborted) return;
    this.isShown = true;
    this.shownAt.push(performance.now());
    this.#timers.push(setTimeout(() => this.recovery.noteReady(), PICTURE_MS));
    if (this.#killsAfterMs === undefined) return;
    this.#timers.push(setTimeout(() => this.#page.lose(), PICTURE_MS + this.#killsAfterMs));
  }

  onLoss(device: GPUDevice): void {
    this.isShown = false;
    for (const timer of this.#timers.splice(0)) clearTimeout(timer);
    this.recovery.noteLoss(device);
    if (!this.recovery.isHopeless) void this.show();
  }

  remove(): void {
    this.#controller.abort();
    this.recovery.end();
    this.isShown = false;
  }
}

const pass = (ms: number) => vi.advanceTimersByTimeAsync(ms);

test("a device that is lost now and then is replaced at once, as often as that happens", async () => {
  const page = new Page();
  const viewers = [page.add(), page.add(), page.add()];
  for (let loss = 0; loss < 20; loss++) {
    await pass(61_000);
    page.lose();
    await pass(1);
    expect(viewers.every(({ isShown }) => isShown)).toBe(true);
  }
});

test.each([-50, 0, 300, 3000, 20_000])(
  "a scene that loses the device %d ms after each picture waits longer each time, and then stops",
  async (killsAfterMs) => {
    const page = new Page();
    const killer = page.add(killsAfterMs);
    await pass(300_000);
    expect(killer.recovery.isHopeless).toBe(true);
    expect(page.losses).toBe(5);
    const pauses = killer.shownAt.slice(1).map((at, i) => at - killer.shownAt[i]! - PICTURE_MS - killsAfterMs);
    expect(pauses).toEqual([0, 1000, 2000, 4000]);
  },
);

test.each([
  [0, 1],
  [0, 9],
  [300, 9],
  [3000, 1],
  [3000, 9],
])("a scene that loses the device after %d ms is told from %d innocent ones, which go on", async (ms, count) => {
  for (const place of [0, Math.floor(count / 2), count]) {
    const page = new Page();
    const innocent: Viewer[] = [];
    for (let i = 0; i < place; i++) innocent.push(page.add());
    const killer = page.add(ms);
    for (let i = place; i < count; i++) innocent.push(page.add());
    await pass(600_000);
    expect(killer.recovery.isHopeless).toBe(true);
    expect(innocent.map(({ isShown }) => isShown)).toEqual(innocent.map(() => true));
    expect(page.losses).toBeLessThanOrEqual(10);
  }
});

test("a scene that comes to a page of trusted ones and loses the device is known from the first time", async () => {
  const page = new Page();
  const innocent = [page.add(), page.add()];
  await pass(5000);
  const killer = page.add(0);
  await pass(200_000);
  expect(killer.recovery.isHopeless).toBe(true);
  expect(page.losses).toBe(5);
  for (const viewer of innocent) expect(viewer.shownAt).toHaveLength(6); // back at once each time
});

test("whoever asks for a hopeless scene gets another try", async () => {
  const page = new Page();
  const killer = page.add(0);
  await pass(60_000);
  expect(page.losses).toBe(5);
  killer.recovery.forgive();
  expect(killer.recovery.isHopeless).toBe(false);
  void killer.show();
  await pass(60_000);
  expect(page.losses).toBe(10);
  expect(killer.recovery.isHopeless).toBe(true);
});

test("nobody waits for a viewer that was removed, on trial or in the queue", async () => {
  const page = new Page();
  const viewers = [page.add(), page.add(), page.add()];
  for (const _ of [0, 1]) {
    await pass(200);
    page.lose();
  }
  await pass(1010); // the pause, and then one begins
  const [first, second, third] = viewers as [Viewer, Viewer, Viewer];
  expect(viewers.map(({ isShown }) => isShown)).toEqual([true, false, false]);
  second.remove();
  first.remove();
  await pass(10);
  expect(third.isShown).toBe(true);
});
