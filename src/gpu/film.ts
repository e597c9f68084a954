import { BufferUsage, MapMode } from "./flags";

const BYTES_PER_PIXEL = 16;
const CARRY_BYTES_PER_PIXEL = 8;
/** Rays traced and samples dropped: two u32. */
export const COUNTER_BYTES = 8;

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

  constructor(device: GPUDevice, width: number, height: number) {
    this.#device = device;
    this.width = width;
    this.height = height;
    const usage = BufferUsage.STORAGE | BufferUsage.COPY_DST | BufferUsage.COPY_SRC;
    this.sums = device.createBuffer({ label: "film", size: 2 * width * height * BYTES_PER_PIXEL, usage });
    const carryBytes = 2 * width * height * CARRY_BYTES_PER_PIXEL;
    this.carries = device.createBuffer({ label: "film carries", size: carryBytes, usage });
    this.counters = device.createBuffer({ label: "counters", size: COUNTER_BYTES, usage });
  }

  clear(encoder: GPUCommandEncoder): void {
    encoder.clearBuffer(this.sums);
    encoder.clearBuffer(this.carries);
  }

  /** Mean radiance, RGBA with alpha 1, rows from the top; black where there is no sample yet. */
  async read(): Promise<Float32Array> {
    const usage = BufferUsage.COPY_DST | BufferUsage.MAP_READ;
    const staging = this.#device.createBuffer({ label: "film readback", size: this.sums.size, usage });
    const encoder = this.#device.createCommandEncoder({ label: "read film" });
    encoder.copyBufferToBuffer(this.sums, 0, staging, 0, this.sums.size);
    this.#device.queue.submit([encoder.finish()]);
    await staging.mapAsync(MapMode.READ);
    const sums = new Float32Array(staging.getMappedRange());
    const values = this.width * this.height * 4;
    const radiance = new Float32Array(values);
    for (let i = 0; i < values; i += 4) {
      const count = Math.max(sums[i + 3]! + sums[values + i + 3]!, 1);
      for (let c = 0; c < 3; c++) radiance[i + c] = (sums[i + c]! + sums[values + i + c]!) / count;
      radiance[i + 3] = 1;
    }
    staging.destroy();
    return radiance;
  }

  dispose(): void {
    this.sums.destroy();
    this.carries.destroy();
    this.counters.destroy();
  }
}
