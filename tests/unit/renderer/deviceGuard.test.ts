import { expect, test } from "vitest";
import { DeviceGuard } from "../../../src/renderer/deviceGuard";

/** Finds fault, once, with the first work that is done on it. */
function fakeDevice(fault?: Error) {
  const faults = fault ? [fault] : [];
  const calls: string[] = [];
  const device = {
    pushErrorScope: (filter: string) => calls.push(`push ${filter}`),
    popErrorScope: async () => faults.pop() ?? null,
    destroy: () => calls.push("destroy"),
  };
  return { device: device as unknown as GPUDevice, calls };
}

test("work gives what it gives, inside of an error scope, and nothing has failed", async () => {
  const { device, calls } = fakeDevice();
  const guard = new DeviceGuard(device, false);
  expect(guard.run(() => calls.length)).toBe(3);
  await new Promise((resolve) => setTimeout(resolve));
  expect(guard.hasFailed).toBe(false);
  guard.throwFailure();
});

test("what the device says against work is thrown later, and what follows from it is not", async () => {
  const { device } = fakeDevice(new Error("usages must not be 0"));
  const guard = new DeviceGuard(device, false);
  guard.run(() => undefined);
  await new Promise((resolve) => setTimeout(resolve));
  guard.fail(new Error("the buffer is invalid"));
  expect(guard.hasFailed).toBe(true);
  expect(() => guard.throwFailure()).toThrow("usages must not be 0");
});

test.each([true, false])("a device that is its own (%s) ends with it, and one that was lent does not", (isOwned) => {
  const { device, calls } = fakeDevice();
  new DeviceGuard(device, isOwned).dispose();
  expect(calls.includes("destroy")).toBe(isOwned);
});
