import { UnsupportedError } from "../errors";

type Limit = "maxTextureDimension2D" | "maxComputeWorkgroupsPerDimension";

/** @throws {UnsupportedError} that names the limit and the need, if `count` is more than the device allows. */
export function checkCount(limits: GPUSupportedLimits, limit: Limit, count: number, what: string): void {
  const most = limits[limit];
  if (count > most) throw new UnsupportedError(`${limit} is ${most}; ${what} needs ${count}`);
}

/** The same, of a storage buffer. Without this it would be made invalid, and what is drawn from it black. */
export function checkStorage(limits: GPUSupportedLimits, bytes: number, what: string): void {
  for (const limit of ["maxStorageBufferBindingSize", "maxBufferSize"] as const) {
    if (bytes <= limits[limit]) continue;
    const [most, need] = [limits[limit], bytes].map((size) => `${Math.ceil(size / 2 ** 20)} MiB`);
    throw new UnsupportedError(`${limit} is ${most}; ${what} needs ${need}`);
  }
}
