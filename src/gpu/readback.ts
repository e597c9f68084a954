import { ERROR_BYTES, type ErrorPass } from "./errorPass";
import { COUNTER_BYTES, type Film } from "./film";
import { BufferUsage, MapMode } from "./flags";

const TIMESTAMP_BYTES = 16;
const COUNTERS_AT = TIMESTAMP_BYTES;
const ERROR_AT = COUNTERS_AT + COUNTER_BYTES;

/** What one submit reports back. */
export type Report = {
  /** Milliseconds between begin and end of the trace pass; undefined where the device has no timestamps. */
  readonly gpuMs: number | undefined;
  readonly rays: number;
  readonly badSamples: number;
  /** The error pass's partial sums, if it ran. */
  readonly errorSums: Float32Array | undefined;
};

/** Brings timestamps, counters and error sums back with one buffer, one submit at a time. */
export class Readback {
  /** For the trace pass; undefined where the device has no timestamps. */
  readonly timestampWrites: GPUComputePassTimestampWrites | undefined;
  readonly #querySet: GPUQuerySet | undefined;
  readonly #resolved: GPUBuffer | undefined;
  readonly #staging: GPUBuffer;

  constructor(device: GPUDevice) {
    const { COPY_DST, COPY_SRC, MAP_READ, QUERY_RESOLVE } = BufferUsage;
    const bytes = ERROR_AT + ERROR_BYTES;
    this.#staging = device.createBuffer({ label: "readback", size: bytes, usage: COPY_DST | MAP_READ });
    if (!device.features.has("timestamp-query")) return;
    this.#querySet = device.createQuerySet({ label: "trace time", type: "timestamp", count: 2 });
    this.#resolved = device.createBuffer({
      label: "trace time",
      size: TIMESTAMP_BYTES,
      usage: QUERY_RESOLVE | COPY_SRC,
    });
    this.timestampWrites = { querySet: this.#querySet, beginningOfPassWriteIndex: 0, endOfPassWriteIndex: 1 };
  }

  /** Encodes the copies; clears the counters for the next submit. */
  encode(encoder: GPUCommandEncoder, film: Film, errorPass: ErrorPass | undefined): void {
    if (this.#querySet && this.#resolved) {
      encoder.resolveQuerySet(this.#querySet, 0, 2, this.#resolved, 0);
      encoder.copyBufferToBuffer(this.#resolved, 0, this.#staging, 0, TIMESTAMP_BYTES);
    }
    encoder.copyBufferToBuffer(film.counters, 0, this.#staging, COUNTERS_AT, COUNTER_BYTES);
    encoder.clearBuffer(film.counters);
    if (errorPass) encoder.copyBufferToBuffer(errorPass.partialSums, 0, this.#staging, ERROR_AT, ERROR_BYTES);
  }

  /** Resolves when the submit is done. */
  async read(hasErrorSums: boolean): Promise<Report> {
    await this.#staging.mapAsync(MapMode.READ);
    const bytes = this.#staging.getMappedRange().slice(0);
    this.#staging.unmap();
    const [begin, end] = new BigUint64Array(bytes, 0, 2);
    const [rays, badSamples] = new Uint32Array(bytes, COUNTERS_AT, 2);
    return {
      gpuMs: this.#querySet && end! > begin! ? Number(end! - begin!) / 1e6 : undefined,
      rays: rays!,
      badSamples: badSamples!,
      errorSums: hasErrorSums ? new Float32Array(bytes, ERROR_AT) : undefined,
    };
  }

  dispose(): void {
    this.#staging.destroy();
    this.#querySet?.destroy();
    this.#resolved?.destroy();
  }
}
