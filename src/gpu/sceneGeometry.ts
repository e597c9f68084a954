import { WebGpuError } from "../errors";
import { nextTask } from "../nextTask";
import type { Geometry } from "../tree/geometry";
import { scoped } from "./errorScope";
import { BufferUsage, TextureUsage } from "./flags";
import { GEOMETRY_BINDINGS } from "./geometryLayout";
import { checkCount, checkStorage } from "./limits";

/** A scene's geometry on the GPU. */
export class SceneGeometry {
  readonly source: Geometry;
  readonly #resources = new Map<number, GPUBuffer | GPUTexture>();
  #filling: Promise<void> | undefined;
  #isDisposed = false;

  /**
   * @throws {UnsupportedError} if the device has no room for so much in one piece.
   * @throws {WebGpuError} if there is no memory to upload it from.
   */
  constructor(device: GPUDevice, geometry: Geometry) {
    this.source = geometry;
    const { texels, ...arrays } = geometry.data;
    try {
      for (const [part, bytes] of Object.entries(arrays) as [keyof typeof arrays, ArrayBuffer | undefined][]) {
        const { binding, row } = GEOMETRY_BINDINGS[part];
        if (bytes === undefined) continue;
        this.#resources.set(binding, row ? createTexels(device, part, bytes, row) : createBuffer(device, part, bytes));
      }
      if (texels !== undefined) {
        this.#resources.set(GEOMETRY_BINDINGS.texels.binding, this.#createPictures(device, texels));
      }
    } catch (error) {
      this.dispose();
      throw error;
    }
  }

  /** Pending while pictures are copied, a slice in each task; what is rendered before that lacks them. */
  get filling(): Promise<void> | undefined {
    return this.#filling;
  }

  #createPictures(device: GPUDevice, pictures: readonly Uint8Array[]): GPUBuffer {
    const size = pictures.reduce((sum, { length }) => sum + length, 0);
    checkStorage(device.limits, size, nameOf("texels"));
    const usage = BufferUsage.STORAGE | BufferUsage.COPY_DST;
    const buffer = device.createBuffer({ label: "texels", size, usage });
    const slices = slicesOf(pictures);
    const write = ({ from, start, length, to }: Slice) => device.queue.writeBuffer(buffer, to, from, start, length);
    if (size <= SLICE_BYTES) for (const slice of slices) write(slice);
    else {
      // Where there was no memory for the buffer, whoever made it is told so; that it can't be written is no news.
      this.#filling = this.#writeInTasks(slices, (slice) => scoped(device, () => write(slice))).finally(() => {
        this.#filling = undefined;
      });
    }
    return buffer;
  }

  async #writeInTasks(slices: Iterable<Slice>, write: (slice: Slice) => void): Promise<void> {
    for (const slice of slices) {
      await nextTask();
      if (this.#isDisposed) return;
      write(slice);
    }
  }

  /** The entries of a bind group that a layout asks for. */
  entries(layout: readonly GPUBindGroupLayoutEntry[]): GPUBindGroupEntry[] {
    return layout.map(({ binding }) => {
      const resource = this.#resources.get(binding)!;
      return { binding, resource: "createView" in resource ? resource.createView() : { buffer: resource } };
    });
  }

  dispose(): void {
    this.#isDisposed = true;
    for (const resource of this.#resources.values()) resource.destroy();
  }
}

/** Copied in one task: 4 MiB take a few milliseconds. */
const SLICE_BYTES = 2 ** 22;

/** So many bytes of a picture, from its byte `start`, and where they go. */
type Slice = { readonly from: Uint8Array; readonly start: number; readonly length: number; readonly to: number };

function* slicesOf(pictures: readonly Uint8Array[]): Generator<Slice> {
  let to = 0;
  for (const from of pictures) {
    for (let start = 0; start < from.length; start += SLICE_BYTES) {
      const length = Math.min(SLICE_BYTES, from.length - start);
      yield { from, start, length, to };
      to += length;
    }
  }
}

function createBuffer(device: GPUDevice, label: string, bytes: ArrayBuffer): GPUBuffer {
  const size = bytes.byteLength;
  checkStorage(device.limits, size, nameOf(label));
  let buffer: GPUBuffer | undefined;
  try {
    buffer = device.createBuffer({ label, size, usage: BufferUsage.STORAGE, mappedAtCreation: true });
    new Uint8Array(buffer.getMappedRange()).set(new Uint8Array(bytes));
    buffer.unmap();
    return buffer;
  } catch (cause) {
    buffer?.destroy();
    throw new WebGpuError(`there is no memory for ${nameOf(label)}`, { cause });
  }
}

const TEXEL_BYTES = 16;

/** Words, four in a texel, in rows. */
function createTexels(device: GPUDevice, label: string, bytes: ArrayBuffer, row: number): GPUTexture {
  const texels = bytes.byteLength / TEXEL_BYTES;
  const fullRows = Math.floor(texels / row);
  const rest = texels % row;
  checkCount(device.limits, "maxTextureDimension2D", Math.max(row, Math.ceil(texels / row)), nameOf(label));
  const texture = device.createTexture({
    label,
    size: [row, Math.max(fullRows + (rest > 0 ? 1 : 0), 1)],
    format: "rgba32uint",
    usage: TextureUsage.TEXTURE_BINDING | TextureUsage.COPY_DST,
  });
  const write = (y: number, width: number, height: number) => {
    const layout = { offset: y * row * TEXEL_BYTES, bytesPerRow: row * TEXEL_BYTES };
    device.queue.writeTexture({ texture, origin: [0, y] }, bytes, layout, [width, height]);
  };
  if (fullRows > 0) write(0, row, fullRows);
  if (rest > 0) write(fullRows, rest, 1);
  return texture;
}

function nameOf(label: string): string {
  return `the scene's geometry (${label})`;
}
