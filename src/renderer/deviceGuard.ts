import { scoped } from "../gpu/errorScope";

/** The device that a tracer works on, and what first went wrong with that work: from then on there is none. */
export class DeviceGuard {
  readonly device: GPUDevice;
  readonly #isOwned: boolean;
  #failure: unknown;

  /** @param isOwned - whether the device ends with the tracer. */
  constructor(device: GPUDevice, isOwned: boolean) {
    this.device = device;
    this.#isOwned = isOwned;
  }

  get hasFailed(): boolean {
    return this.#failure !== undefined;
  }

  /** @throws what went wrong first. */
  throwFailure(): void {
    if (this.#failure !== undefined) throw this.#failure;
  }

  /** Takes note that something went wrong; for promises that nobody waits for. */
  readonly fail = (error: unknown): void => {
    this.#failure ??= error;
  };

  /**
   * Does GPU work. What the device says against it ends this tracer alone: a bug of ours, or a device out of memory. Calls are
   * not nested, so that errors come in the order of their causes.
   */
  run<T>(work: () => T): T {
    const { value, error } = scoped(this.device, work);
    void error.then((failure) => failure && this.fail(failure));
    return value;
  }

  dispose(): void {
    if (this.#isOwned) this.device.destroy();
  }
}
