import { RtViewerError } from "../errors";
import { download } from "./download";
import { BufferUsage } from "./flags";
import { checkStorage } from "./limits";

const BYTES_PER_PIXEL = 16;
const CARRY_BYTES_PER_PIXEL = 8;
/** Rays traced and samples dropped: two u32. */
export const COUNTER_BYTES = 8;

/** What a film holds, for whoever shows it. */
export type FilmSums = Pick<Film, "width" | "height" | "sums">;

/** Where samples add up: per pixel and half, a sum of radiance and the number of samples in it. */
export class Film {
  readonly width: number;
  readonly height: number;
  /** Half 0, then half 1; rows from the top; rgb and, in w, the sample count. */
  readonly sums: GPUBuffer;
  /** What the sums leave over, in the same order: see `film.wgsl`. The trace pass alone uses it. */
  readonly carries: GPUBuffer;
  readonly counters: GPUBuffer;
  readonly #device: GPUDevice;

  /** The size has been checked by `checkFilmSize`. */
  constructor(device: GPUDevice, width: number, height: number) {
    this.#device = device;
    this.width = width;
    this.height = height;
    const usage = BufferUsage.STORAGE | BufferUsage.COPY_DST | BufferUsage.COPY_SRC;
    this.sums = device.createBuffer({ label: "film", size: sumsBytes(width, height), usage });
    const carryBytes = 2 * width * height * CARRY_BYTES_PER_PIXEL;
    this.carries = device.createBuffer({ label: "film carries", size: carryBytes, usage });
    this.counters = device.createBuffer({ label: "counters", size: COUNTER_BYTES, usage });
  }

  clear(encoder: GPUCommandEncoder): void {
    encoder.clearBuffer(this.sums);
    encoder.clearBuffer(this.carries);
  }

  /**
   * Mean radiance at the moment of the call, RGBA with alpha 1, rows from the top; black where there is no sample yet.
   *
   * @throws {WebGpuError} if the device fails.
   */
  read(): Promise<Float32Array> {
    const { size } = this.sums;
    const copy = (encoder: GPUCommandEncoder, staging: GPUBuffer) =>
      encoder.copyBufferToBuffer(this.sums, 0, staging, 0, size);
    return download(this.#device, "film readback", size, copy, meanRadiance);
  }

  /** What it holds at the moment of the call, for who needs that later and then destroys it. */
  copy(): FilmSums {
    const { width, height } = this;
    const { size } = this.sums;
    const usage = BufferUsage.STORAGE | BufferUsage.COPY_DST;
    const sums = this.#device.createBuffer({ label: "film copy", size, usage });
    const encoder = this.#device.createCommandEncoder({ label: "film copy" });
    encoder.copyBufferToBuffer(this.sums, 0, sums, 0, size);
    this.#device.queue.submit([encoder.finish()]);
    return { width, height, sums };
  }

  dispose(): void {
    this.sums.destroy();
    this.carries.destroy();
    this.counters.destroy();
  }
}

/** @throws {RtViewerError} if there is no film of this size, or none on this device. */
export function checkFilmSize({ limits }: GPUDevice, width: number, height: number): void {
  const picture = `a picture of ${width} × ${height} pixels`;
  if (![width, height].every((side) => Number.isSafeInteger(side) && side >= 1)) {
    throw new RtViewerError(`expected width and height in whole pixels, at least 1 × 1, got ${width} × ${height}`);
  }
  checkStorage(limits, sumsBytes(width, height), picture);
}

function sumsBytes(width: number, height: number): number {
  return 2 * width * height * BYTES_PER_PIXEL;
}

function meanRadiance(bytes: ArrayBuffer): Float32Array {
  const sums = new Float32Array(bytes);
  const values = sums.length / 2;
  const radiance = new Float32Array(values);
  for (let i = 0; i < values; i += 4) {
    const count = Math.max(sums[i + 3]! + sums[values + i + 3]!, 1);
    for (let c = 0; c < 3; c++) radiance[i + c] = (sums[i + c]! + sums[values + i + c]!) / count;
    radiance[i + 3] = 1;
  }
  return radiance;
}
