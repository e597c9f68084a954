import type { Geometry } from "../compile/geometry";
import { WebGpuError } from "../errors";
import { BufferUsage, TextureUsage } from "./flags";
import { GEOMETRY_BINDINGS, type GeometryPart } from "./geometryLayout";
import { checkCount, checkStorage } from "./limits";

/** A scene's geometry on the GPU. */
export class SceneGeometry {
  readonly source: Geometry;
  readonly #resources = new Map<number, GPUBuffer | GPUTexture>();

  /**
   * @throws {UnsupportedError} if the device has no room for so much in one piece.
   * @throws {WebGpuError} if there is no memory to upload it from.
   */
  constructor(device: GPUDevice, geometry: Geometry) {
    this.source = geometry;
    try {
      for (const [part, bytes] of Object.entries(geometry.data) as [GeometryPart, ArrayBuffer | undefined][]) {
        const { binding, row } = GEOMETRY_BINDINGS[part];
        if (bytes === undefined) continue;
        this.#resources.set(binding, row ? createTexels(device, part, bytes, row) : createBuffer(device, part, bytes));
      }
    } catch (error) {
      this.dispose();
      throw error;
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
    for (const resource of this.#resources.values()) resource.destroy();
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
