import type { Geometry } from "../compile/geometry";
import { UnsupportedError } from "../errors";
import { BufferUsage, TextureUsage } from "./flags";
import { GEOMETRY_BINDINGS, type GeometryPart } from "./geometryLayout";

/** A scene's geometry on the GPU. */
export class SceneGeometry {
  readonly source: Geometry;
  readonly #resources: ReadonlyMap<number, GPUBuffer | GPUTexture>;

  /** @throws {UnsupportedError} if the device has no room for so much in one piece. */
  constructor(device: GPUDevice, geometry: Geometry) {
    this.source = geometry;
    const data = Object.entries(geometry.data) as [GeometryPart, ArrayBuffer | undefined][];
    this.#resources = new Map(
      data.flatMap(([part, bytes]) => {
        const { binding, row } = GEOMETRY_BINDINGS[part];
        if (bytes === undefined) return [];
        return [[binding, row ? createTexels(device, part, bytes, row) : createBuffer(device, part, bytes)]];
      }),
    );
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
  checkSize(label, size, device.limits.maxStorageBufferBindingSize);
  const buffer = device.createBuffer({ label, size, usage: BufferUsage.STORAGE, mappedAtCreation: true });
  new Uint8Array(buffer.getMappedRange()).set(new Uint8Array(bytes));
  buffer.unmap();
  return buffer;
}

const TEXEL_BYTES = 16;

/** Words, four in a texel, in rows. */
function createTexels(device: GPUDevice, label: string, bytes: ArrayBuffer, row: number): GPUTexture {
  const texels = bytes.byteLength / TEXEL_BYTES;
  const fullRows = Math.floor(texels / row);
  const rest = texels % row;
  checkSize(label, bytes.byteLength, device.limits.maxTextureDimension2D * row * TEXEL_BYTES);
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

function checkSize(label: string, bytes: number, limit: number): void {
  if (bytes <= limit) return;
  const [needed, available] = [bytes, limit].map((size) => `${Math.ceil(size / 2 ** 20)} MiB`);
  throw new UnsupportedError(
    `the ${label} of the scene's geometry need ${needed}; this device has room for ${available}`,
  );
}
