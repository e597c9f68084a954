// A device that lives this long, in milliseconds, after the last viewer has come to it is not lost by a viewer's coming back.
const CALM_MS = 60_000;
// A viewer to which this many losses in a row are put down is not shown again by itself.
const MOST_LOSSES = 5;
// Before a viewer comes back, from the second loss on, doubled with each further one.
const PAUSE_MS = 1000;
// How long a viewer has to live after its first picture to be trusted. It doubles with each loss of the page, so that a scene
// which takes a while to bring the device down is found too, up to a time that others can wait.
const TRIAL_MS = 250;
const LONGEST_TRIAL_MS = 4000;

/** Viewers that have come to a device and are not trusted yet, and those that wait until there are none. */
const onTrial = new Set<Recovery>();
const waiting: { readonly recovery: Recovery; readonly begin: () => void }[] = [];
/** Who was on trial when a device was lost: all its viewers ask, one after the other. */
const suspectsOf = new WeakMap<GPUDevice, ReadonlySet<Recovery>>();
let recentLosses = 0;
/** When one last came to a device. */
let begunAt = Number.NEGATIVE_INFINITY;

/**
 * Decides when a viewer comes back after the device was lost, and whether it does.
 *
 * A scene may be what the device is lost by, and then is so each time; but all viewers of a page share the device, and the
 * browser does not tell whose work brought it down. So a loss is put down to the viewers on trial, or to all if there are
 * none. Whoever has two or more to its name comes back only when nobody else is on trial: the next loss tells who it was.
 */
export class Recovery {
  #losses = 0;
  #begunAt = Number.NEGATIVE_INFINITY;
  #trust: ReturnType<typeof setTimeout> | undefined;

  /** Whether it is not to be tried again until somebody asks for it. */
  get isHopeless(): boolean {
    return this.#losses >= MOST_LOSSES;
  }

  /** Somebody asks for it. */
  forgive(): void {
    if (this.isHopeless) this.#losses = 0;
  }

  /** The device it was on is lost. */
  noteLoss(device: GPUDevice): void {
    const now = performance.now();
    let suspects = suspectsOf.get(device);
    if (suspects === undefined) {
      suspects = new Set(onTrial);
      suspectsOf.set(device, suspects);
      recentLosses = now - begunAt > CALM_MS ? 1 : recentLosses + 1;
    }
    this.end();
    if (suspects.size > 0 && !suspects.has(this)) return;
    this.#losses = now - this.#begunAt > CALM_MS ? 1 : this.#losses + 1;
    if (this.isHopeless) recentLosses = 1; // the others need not be on trial for long
  }

  /** Begins its trial: resolves when it may ask for a device, or `signal` is aborted; then there is no trial. */
  async begin(signal: AbortSignal): Promise<void> {
    if (this.#losses >= 2) {
      const pauseMs = PAUSE_MS * 2 ** (this.#losses - 2);
      await until((resolve) => setTimeout(resolve, pauseMs), signal);
      if (onTrial.size > 0) await until((begin) => waiting.push({ recovery: this, begin }), signal);
    }
    if (signal.aborted) return this.end();
    onTrial.add(this);
    this.#begunAt = begunAt = performance.now();
  }

  /** It has shown a picture. */
  noteReady(): void {
    if (!onTrial.has(this)) return;
    clearTimeout(this.#trust);
    this.#trust = setTimeout(() => this.end(), Math.min(TRIAL_MS * 2 ** recentLosses, LONGEST_TRIAL_MS));
  }

  /** Ends its trial, because it is trusted or uses no device. */
  end(): void {
    clearTimeout(this.#trust);
    onTrial.delete(this);
    const place = waiting.findIndex(({ recovery }) => recovery === this);
    if (place >= 0) waiting.splice(place, 1);
    setTimeout(callNext); // after a loss, those who need not wait have begun by then
  }
}

function callNext(): void {
  if (onTrial.size > 0) return;
  const next = waiting.shift();
  if (next === undefined) return;
  onTrial.add(next.recovery); // now, or two could begin at once
  next.begin();
}

/** Resolves when `start`'s argument is called, or the signal is aborted. */
function until(start: (resolve: () => void) => void, signal: AbortSignal): Promise<void> {
  return new Promise((resolve) => {
    if (signal.aborted) return resolve();
    const end = () => {
      signal.removeEventListener("abort", end);
      resolve();
    };
    signal.addEventListener("abort", end);
    start(end);
  });
}
