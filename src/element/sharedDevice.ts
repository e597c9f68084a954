import { requestDevice } from "../gpu/device";

type Shared = { readonly opening: Promise<GPUDevice>; userCount: number };

/** The right to use a device, until it is released. */
export type DeviceLease = {
  readonly device: GPUDevice;
  /** Idempotent. With the last lease the device is destroyed. */
  readonly release: () => void;
};

let shared: Shared | undefined;

/**
 * Gives the one device that all viewers of a page share; after it has been lost, the next one.
 *
 * @throws {WebGpuError} if there is none.
 */
export async function leaseDevice(): Promise<DeviceLease> {
  shared ??= open();
  const mine = shared;
  mine.userCount += 1;
  let isReleased = false;
  const release = () => {
    if (isReleased) return;
    isReleased = true;
    mine.userCount -= 1;
    if (mine.userCount > 0) return;
    if (shared === mine) shared = undefined;
    mine.opening.then(
      (device) => device.destroy(),
      () => undefined, // whoever waited for it was told
    );
  };
  try {
    return { device: await mine.opening, release };
  } catch (error) {
    release();
    throw error;
  }
}

function open(): Shared {
  const opened = { opening: requestDevice(), userCount: 0 };
  const forget = () => {
    if (shared === opened) shared = undefined;
  };
  opened.opening.then(({ lost }) => lost).then(forget, forget);
  return opened;
}
