import type { Film } from "./film";
import { BufferUsage } from "./flags";

// Enough to fill a GPU; each reads a strided share of the film.
const WORKGROUPS = 64;

/** Bytes of the partial sums that the pass writes. */
export const ERROR_BYTES = WORKGROUPS * 16;

/** The compute pass that estimates the film's relative RMSE from its two halves. */
export class ErrorPass {
  /** One vec4f per workgroup; see `wgsl/error.wgsl`. */
  readonly partialSums: GPUBuffer;
  readonly #pipeline: GPUComputePipeline;
  readonly #uniforms: GPUBuffer;
  readonly #bindGroup: GPUBindGroup;

  constructor(device: GPUDevice, pipeline: GPUComputePipeline, film: Film) {
    this.#pipeline = pipeline;
    this.partialSums = device.createBuffer({
      label: "error sums",
      size: ERROR_BYTES,
      usage: BufferUsage.STORAGE | BufferUsage.COPY_SRC,
    });
    this.#uniforms = device.createBuffer({
      label: "error uniforms",
      size: 16,
      usage: BufferUsage.UNIFORM | BufferUsage.COPY_DST,
    });
    device.queue.writeBuffer(this.#uniforms, 0, new Uint32Array([film.width * film.height]));
    this.#bindGroup = device.createBindGroup({
      label: "error",
      layout: pipeline.getBindGroupLayout(0),
      entries: [this.#uniforms, film.sums, this.partialSums].map((buffer, binding) => ({
        binding,
        resource: { buffer },
      })),
    });
  }

  encode(encoder: GPUCommandEncoder): void {
    const pass = encoder.beginComputePass({ label: "error" });
    pass.setPipeline(this.#pipeline);
    pass.setBindGroup(0, this.#bindGroup);
    pass.dispatchWorkgroups(WORKGROUPS);
    pass.end();
  }

  dispose(): void {
    this.partialSums.destroy();
    this.#uniforms.destroy();
  }
}

/**
 * Estimated relative RMSE: sqrt(mean squared error) / mean, over all pixels and channels. `Infinity` until both halves of
 * some pixel hold a sample, and while all samples are black: the light may only not have been found yet.
 */
export function relativeError(partialSums: Float32Array): number {
  let squaredError = 0;
  let radiance = 0;
  let pixels = 0;
  for (let i = 0; i < partialSums.length; i += 4) {
    squaredError += partialSums[i]!;
    radiance += partialSums[i + 1]!;
    pixels += partialSums[i + 2]!;
  }
  if (radiance === 0) return Number.POSITIVE_INFINITY;
  const values = 3 * pixels;
  return Math.sqrt(squaredError / values) / (radiance / values);
}
