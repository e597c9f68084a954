import { WebGpuError } from "../errors";

// Popped last first. A buffer that finds no memory is an invalid buffer to what comes after: the cause is to be told.
const FILTERS = ["validation", "out-of-memory", "internal"] as const;

/** What GPU work gave, and what the device says against it a moment later. */
export type Scoped<T> = { readonly value: T; readonly error: Promise<WebGpuError | undefined> };

/**
 * Does GPU work of one owner, whose errors then are the owner's. All that is made on a device or submitted to it goes through
 * here, because viewers and the page itself share the device: `uncapturederror` would tell everyone of everyone's errors.
 *
 * @param work - synchronous: scopes are a stack of the device's, so one that stayed open over an `await` would catch errors of others.
 * @throws what `work` throws.
 */
export function scoped<T>(device: GPUDevice, work: () => T): Scoped<T> {
  for (const filter of FILTERS) device.pushErrorScope(filter);
  let value: T;
  try {
    value = work();
  } catch (error) {
    void popAll(device); // the exception tells it
    throw error;
  }
  return { value, error: popAll(device) };
}

/** The same for work that can be waited for. @throws {WebGpuError} what the device says against it. */
export async function checked<T>(device: GPUDevice, work: () => T): Promise<T> {
  const { value, error } = scoped(device, work);
  const failure = await error;
  if (failure !== undefined) throw failure;
  return value;
}

async function popAll(device: GPUDevice): Promise<WebGpuError | undefined> {
  const pops = FILTERS.map(() => device.popErrorScope());
  try {
    const cause = (await Promise.all(pops)).find((error) => error !== null);
    return cause && new WebGpuError(cause.message, { cause });
  } catch {
    return undefined; // the device is lost, which `device.lost` tells
  }
}
