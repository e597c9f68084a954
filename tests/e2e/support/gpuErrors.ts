import type { Page } from "@playwright/test";

/** What devices of the page said against work on them. */
export type GpuErrors = {
  /** Outside of every error scope: `uncapturederror`. */
  readonly uncaptured: readonly string[];
  /** In a scope of somebody. */
  readonly captured: readonly string[];
};

/** Collects the errors of all devices from the next page on. To be called before the page is opened. */
export async function collectGpuErrors(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const errors = { uncaptured: [] as string[], captured: [] as string[] };
    Object.assign(globalThis, { gpuErrors: errors });
    const { requestDevice } = GPUAdapter.prototype;
    GPUAdapter.prototype.requestDevice = async function (...args) {
      const device = await requestDevice.apply(this, args);
      device.addEventListener("uncapturederror", ({ error }) => errors.uncaptured.push(error.message));
      return device;
    };
    const { popErrorScope } = GPUDevice.prototype;
    GPUDevice.prototype.popErrorScope = async function () {
      const error = await popErrorScope.call(this);
      if (error) errors.captured.push(error.message);
      return error;
    };
  });
}

export function gpuErrorsOf(page: Page): Promise<GpuErrors> {
  return page.evaluate(() => (globalThis as unknown as { gpuErrors: GpuErrors }).gpuErrors);
}
