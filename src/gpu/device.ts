import { WebGpuError } from "../errors";

/**
 * Requests a device that can run the tracer.
 *
 * @param gpu - `navigator.gpu` by default; in Node, pass what Dawn's `create` returns.
 * @throws {WebGpuError} if there is no WebGPU or no adapter, or the adapter refuses.
 */
export async function requestDevice(gpu: GPU | undefined = globalThis.navigator?.gpu): Promise<GPUDevice> {
  if (!gpu) {
    throw new WebGpuError("WebGPU is not available; it needs a recent browser and a secure (https or localhost) page");
  }
  const adapter = await gpu.requestAdapter({ powerPreference: "high-performance" });
  if (!adapter) throw new WebGpuError("WebGPU found no graphics adapter; hardware acceleration may be turned off");
  const { maxStorageBufferBindingSize, maxBufferSize } = adapter.limits;
  try {
    return await adapter.requestDevice({
      label: "rt-viewer",
      requiredFeatures: adapter.features.has("timestamp-query") ? ["timestamp-query"] : [],
      requiredLimits: { maxStorageBufferBindingSize, maxBufferSize },
    });
  } catch (cause) {
    throw new WebGpuError("the graphics adapter refused to open a device", { cause });
  }
}

/** Vendor, architecture and description of the device's adapter, as far as it tells. */
export function adapterName(device: GPUDevice): string {
  const { vendor, architecture, description } = device.adapterInfo;
  const parts = [vendor, architecture, description].filter((part) => part !== "");
  return [...new Set(parts)].join(" · ") || "unknown adapter";
}

// Work on a lost device fails up to this many milliseconds before the device says that it is lost.
const LOSS_NOTICE_MS = 100;

/** What to throw when work on a device has failed: undefined if it is not for the device's loss, which may be told a moment later. */
export function lossOf(device: GPUDevice): Promise<WebGpuError | undefined> {
  const loss = device.lost.then(
    ({ message }) => new WebGpuError(`The GPU device was lost${message === "" ? "" : `: ${message}`}`),
  );
  return Promise.race([loss, sleep(LOSS_NOTICE_MS)]);
}

export function sleep(ms: number): Promise<undefined> {
  return new Promise((resolve) => setTimeout(resolve, ms));
}

/**
 * Whether waiting for the device costs it speed: while a promise is pending, Dawn in Node spins Node's event loop, which takes a
 * core from a software adapter. Better sleep through most of the wait.
 */
export function spinsInNode(device: GPUDevice): boolean {
  return "process" in globalThis && device.adapterInfo.isFallbackAdapter;
}
