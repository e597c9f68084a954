import { explainFailure } from "./device";
import { scoped } from "./errorScope";
import { BufferUsage, MapMode } from "./flags";

/**
 * Brings bytes back from the GPU as they are at the moment of the call: what `encode` reads may be changed or destroyed as
 * soon as this has returned.
 *
 * @param encode - copies `size` bytes into the buffer it is given.
 * @param read - takes what it needs of these bytes, which are gone afterwards.
 * @throws {WebGpuError} if that fails, or the device is lost meanwhile.
 */
export async function download<T>(
  device: GPUDevice,
  label: string,
  size: number,
  encode: (encoder: GPUCommandEncoder, staging: GPUBuffer) => void,
  read: (bytes: ArrayBuffer) => T,
): Promise<T> {
  let staging: GPUBuffer | undefined;
  try {
    const { value: mapped, error } = scoped(device, () => {
      staging = device.createBuffer({ label, size, usage: BufferUsage.COPY_DST | BufferUsage.MAP_READ });
      const encoder = device.createCommandEncoder({ label });
      encode(encoder, staging);
      device.queue.submit([encoder.finish()]);
      return staging.mapAsync(MapMode.READ);
    });
    const [failure] = await Promise.all([error, mapped.catch(async (cause) => Promise.reject((await error) ?? cause))]);
    if (failure !== undefined) throw failure;
    return read(staging!.getMappedRange());
  } catch (error) {
    throw await explainFailure(device, error);
  } finally {
    staging?.destroy();
  }
}
