import { expect, test, vi } from "vitest";
import { SceneGeometry } from "../../../src/gpu/sceneGeometry";
import { nextTask } from "../../../src/nextTask";
import type { Geometry } from "../../../src/tree/geometry";

const SLICE_BYTES = 2 ** 22;

/** A device that keeps what is written, and how much of it was written in each task. */
function fakeDevice() {
  const memory: { bytes?: Uint8Array } = {};
  const sizes: number[] = [];
  const destroy = vi.fn();
  const device = {
    limits: { maxStorageBufferBindingSize: 2 ** 30, maxBufferSize: 2 ** 30 },
    pushErrorScope: () => {},
    popErrorScope: async () => null,
    createBuffer: ({ size }: GPUBufferDescriptor) => {
      memory.bytes = new Uint8Array(size);
      return { destroy };
    },
    queue: {
      writeBuffer: (_: unknown, to: number, from: Uint8Array, start: number, length: number) => {
        sizes.push(length);
        memory.bytes!.set(from.subarray(start, start + length), to);
      },
    },
  };
  return { device: device as unknown as GPUDevice, memory, sizes, destroy };
}

const geometryOf = (...texels: Uint8Array[]) => ({ data: { texels } }) as unknown as Geometry;
const picture = (length: number, value: number) => new Uint8Array(length).fill(value);

test("small pictures are on the device at once", () => {
  const { device, memory } = fakeDevice();
  const geometry = new SceneGeometry(device, geometryOf(picture(4, 1), picture(8, 2)));
  expect(geometry.filling).toBeUndefined();
  expect([...memory.bytes!]).toEqual([1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2]);
});

test("large pictures are written one after the other, 4 MiB in each task", async () => {
  const { device, memory, sizes } = fakeDevice();
  const pictures = [picture(2 * SLICE_BYTES + 4, 1), picture(SLICE_BYTES, 2), picture(4, 3)];
  const geometry = new SceneGeometry(device, geometryOf(...pictures));
  expect(sizes).toEqual([]);
  const seen: number[] = [];
  while (geometry.filling !== undefined) {
    await nextTask();
    seen.push(sizes.length);
  }
  expect(sizes).toEqual([SLICE_BYTES, SLICE_BYTES, 4, SLICE_BYTES, 4]);
  expect(seen.every((count, i) => count - (seen[i - 1] ?? 0) <= 1)).toBe(true);
  expect(Buffer.compare(Buffer.concat(pictures), memory.bytes!)).toBe(0);
});

test("pictures of a scene that is gone are not written further, and nobody waits for them", async () => {
  const { device, sizes, destroy } = fakeDevice();
  const geometry = new SceneGeometry(device, geometryOf(picture(5 * SLICE_BYTES, 1)));
  await nextTask();
  geometry.dispose();
  expect(destroy).toHaveBeenCalledOnce();
  await geometry.filling;
  expect(geometry.filling).toBeUndefined();
  expect(sizes.length).toBeLessThan(3);
});
