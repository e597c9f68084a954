import { RtViewerError, UnsupportedError, WebGpuError } from "../errors";

// An adapter may be missing and a device lost at once while the browser starts its GPU process, or starts it again after a
// crash. Milliseconds between attempts: two seconds in all, before anybody is told that there is no WebGPU.
const RETRY_PAUSES_MS = [100, 300, 600, 1000];

/**
 * Requests a device that can run the tracer, several times if need be.
 *
 * @throws {WebGpuError} at once if there is no WebGPU; after two seconds if there is no adapter, or it gives no device that lives.
 */
export async function requestDevice(): Promise<GPUDevice> {
  const gpu = globalThis.navigator?.gpu;
  if (!gpu) {
    throw new WebGpuError("WebGPU is not available; it needs a recent browser and a secure (https or localhost) page");
  }
  for (const pauseMs of RETRY_PAUSES_MS) {
    try {
      return await openDevice(gpu);
    } catch {
      await sleep(pauseMs);
    }
  }
  return openDevice(gpu);
}

/**
 * Requests a device, once.
 *
 * @param gpu - `navigator.gpu`; in Node, what Dawn's `create` returns.
 * @throws {WebGpuError} if there is no adapter, it refuses, or the device is lost at once.
 */
export async function openDevice(gpu: GPU): Promise<GPUDevice> {
  const adapter = await gpu.requestAdapter({ powerPreference: "high-performance" });
  if (!adapter) throw new WebGpuError("WebGPU found no graphics adapter; hardware acceleration may be turned off");
  const { maxStorageBufferBindingSize, maxBufferSize } = adapter.limits;
  const requested = adapter.requestDevice({
    label: "rt-viewer",
    requiredFeatures: adapter.features.has("timestamp-query") ? ["timestamp-query"] : [],
    requiredLimits: { maxStorageBufferBindingSize, maxBufferSize },
  });
  const device = await requested.catch((cause: unknown) => {
    throw new WebGpuError("the graphics adapter refused to open a device", { cause });
  });
  const lost = await Promise.race([device.lost, sleep(0)]);
  if (lost) throw new WebGpuError(`the device was lost as soon as it was opened: ${lost.message}`, { cause: lost });
  return device;
}

/** Vendor, architecture and description of the device's adapter, as far as it tells. */
export function adapterName(device: GPUDevice): string {
  const { vendor, architecture, description } = device.adapterInfo;
  const parts = [vendor, architecture, description].filter((part) => part !== "");
  return [...new Set(parts)].join(" · ") || "unknown adapter";
}

// Work on a lost device fails up to this many milliseconds before the device says that it is lost: on a busy machine 100 is
// too few.
const LOSS_NOTICE_MS = 500;

/** The device's loss, if that is why work on it has failed; undefined if not. It may be told a moment after the work fails. */
export function lossOf(device: GPUDevice): Promise<WebGpuError | undefined> {
  const loss = device.lost.then(
    (cause) => new WebGpuError(`The GPU device was lost${cause.message === "" ? "" : `: ${cause.message}`}`, { cause }),
  );
  return Promise.race([loss, sleep(LOSS_NOTICE_MS)]);
}

/** What to throw when work on a device has failed: its loss, an error of ours as it is, or any other as the cause of one. */
export async function explainFailure(device: GPUDevice, error: unknown): Promise<RtViewerError> {
  if (error instanceof UnsupportedError) return error;
  const loss = await lossOf(device);
  if (loss !== undefined || error instanceof RtViewerError) return loss ?? (error as RtViewerError);
  return new WebGpuError(error instanceof Error ? error.message : String(error), { cause: error });
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
