import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { DeviceLease } from "../../../src/element/sharedDevice";

/** A device as far as the lease cares; `lose` is the browser taking it away. */
class FakeDevice {
  readonly destroy = vi.fn(() => this.lose("destroyed"));
  readonly lost: Promise<unknown>;
  lose!: (reason: string) => void;

  constructor() {
    this.lost = new Promise((resolve) => {
      this.lose = (reason) => resolve({ reason, message: "" });
    });
  }
}

const devices: FakeDevice[] = [];
let missingAdapters = 0;

/** A module of its own for each test: it remembers the page's device. */
let leaseDevice: typeof import("../../../src/element/sharedDevice").leaseDevice;

beforeEach(async () => {
  vi.resetModules();
  vi.useFakeTimers();
  devices.length = 0;
  missingAdapters = 0;
  const requestDevice = async () => {
    const device = new FakeDevice();
    devices.push(device);
    return device;
  };
  const adapter = { limits: {}, features: new Set(), requestDevice };
  const requestAdapter = async () => (missingAdapters-- > 0 ? null : adapter);
  vi.stubGlobal("navigator", { gpu: { requestAdapter } });
  ({ leaseDevice } = await import("../../../src/element/sharedDevice"));
});

afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

/** A device is given after a moment, in which it might be lost. */
async function lease(): Promise<DeviceLease> {
  const leased = leaseDevice();
  await vi.advanceTimersByTimeAsync(0);
  return leased;
}

it("all leases are of one device, destroyed with the last of them", async () => {
  const leases = await Promise.all(Array.from({ length: 10 }, lease));
  expect(devices).toHaveLength(1);
  expect(new Set(leases.map(({ device }) => device)).size).toBe(1);
  const last = leases.pop()!;
  for (const { release } of leases) release();
  leases[0]!.release(); // again
  await Promise.resolve();
  expect(devices[0]!.destroy).not.toHaveBeenCalled();
  last.release();
  await vi.waitFor(() => expect(devices[0]!.destroy).toHaveBeenCalledOnce());
});

it("after the last release there is a new one", async () => {
  (await lease()).release();
  await lease();
  expect(devices).toHaveLength(2);
});

it("a device that was lost is not given again, and its leases do not destroy the next one", async () => {
  const [first, second] = [await lease(), await lease()];
  devices[0]!.lose("unknown");
  await vi.advanceTimersByTimeAsync(0);
  const next = await lease();
  expect(next.device).not.toBe(first.device);
  first.release();
  second.release();
  await vi.advanceTimersByTimeAsync(0);
  expect(devices[1]!.destroy).not.toHaveBeenCalled();
});

it("whoever could not be given one is given one the next time", async () => {
  missingAdapters = 1000;
  const hopeless = expect(leaseDevice()).rejects.toThrow(/adapter/);
  await vi.advanceTimersByTimeAsync(5000);
  await hopeless;
  missingAdapters = 0;
  expect((await lease()).device).toBe(devices[0]);
});
