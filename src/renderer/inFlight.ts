import { explainFailure, sleep, spinsInNode } from "../gpu/device";
import { Readback, type Report } from "../gpu/readback";

// With a second submit waiting, the device does not idle until the next one is made.
const MOST = 2;

/** The submits under way, each with a readback to report through. */
export class InFlight {
  readonly #readbacks: readonly Readback[];
  readonly #reports = new Map<Readback, Promise<void>>();

  readonly #device: GPUDevice;
  readonly #spins: boolean;
  #isDisposed = false;

  constructor(device: GPUDevice) {
    this.#device = device;
    this.#spins = spinsInNode(device);
    this.#readbacks = Array.from({ length: MOST }, () => new Readback(device));
  }

  get isFull(): boolean {
    return this.#reports.size === MOST;
  }

  get isEmpty(): boolean {
    return this.#reports.size === 0;
  }

  /** For the next submit. There must be room. */
  get freeReadback(): Readback {
    return this.#readbacks.find((readback) => !this.#reports.has(readback))!;
  }

  /**
   * Follows a submit until it has reported. Reports are taken in the order of the submits, whichever is read first.
   *
   * @param waitMs - how long it is not worth asking, where asking costs something.
   * @throws {WebGpuError} if the submit failed; where the device was lost, that says so.
   */
  add(readback: Readback, waitMs: number, hasErrorSums: boolean, take: (report: Report) => void): Promise<void> {
    const earlier = Promise.allSettled(this.#reports.values());
    const follow = async () => {
      if (this.#spins && waitMs > 0) await sleep(waitMs);
      if (this.#isDisposed) return;
      const report = await readback.read(hasErrorSums);
      await earlier;
      if (!this.#isDisposed) take(report);
    };
    const reported = follow()
      .catch(async (error: unknown) => {
        if (this.#isDisposed) return;
        throw await explainFailure(this.#device, error);
      })
      .finally(() => this.#reports.delete(readback));
    this.#reports.set(readback, reported);
    return reported;
  }

  /** Resolves when one is done. Rejects as its report does. */
  async any(): Promise<void> {
    await Promise.race(this.#reports.values());
  }

  /** Resolves when all are done. Rejects as one of their reports does. */
  async all(): Promise<void> {
    await Promise.all(this.#reports.values());
  }

  dispose(): void {
    this.#isDisposed = true;
    for (const readback of this.#readbacks) readback.dispose();
  }
}
