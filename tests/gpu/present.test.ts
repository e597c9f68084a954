import { expect, test } from "vitest";
import { BufferUsage, MapMode, TextureUsage } from "../../src/gpu/flags";
import { PathTracer } from "../../src/renderer/pathTracer";
import { testDevice } from "../support/device";
import { loadReference } from "../support/reference";

const [WIDTH, HEIGHT] = [6, 4];
const BYTES_PER_ROW = 256; // WebGPU's least

// The sampler's weights have 8 bits, which is off by one, and the result is rounded to another one.
const TOLERANCE = 2;

test.each([
  [12, 8],
  [17, 9],
  [6, 4],
  [3, 2],
])("a film of 6×4 is presented on %d×%d bilinearly, seed 1", async (width, height) => {
  const { scene } = loadReference("cornell");
  const tracer = await PathTracer.create({ scene, width: WIDTH, height: HEIGHT, device: await testDevice() });
  await tracer.sample(2);
  const film = await tracer.readPicture();
  const shown = await presented(tracer, width, height);
  let worst = 0;
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      for (let c = 0; c < 4; c++) {
        const expected = bilinear(film, ((x + 0.5) * WIDTH) / width - 0.5, ((y + 0.5) * HEIGHT) / height - 0.5, c);
        worst = Math.max(worst, Math.abs(shown(x, y, c) - expected));
      }
    }
  }
  expect(worst).toBeLessThanOrEqual(width === WIDTH ? 0 : TOLERANCE);
  tracer.dispose();
});

function bilinear(film: Uint8ClampedArray, x: number, y: number, channel: number): number {
  const at = (column: number, row: number) => {
    const [i, j] = [Math.min(WIDTH - 1, Math.max(0, column)), Math.min(HEIGHT - 1, Math.max(0, row))];
    return film[(j * WIDTH + i) * 4 + channel]!;
  };
  const [left, top] = [Math.floor(x), Math.floor(y)];
  const [s, t] = [x - left, y - top];
  const above = at(left, top) * (1 - s) + at(left + 1, top) * s;
  const below = at(left, top + 1) * (1 - s) + at(left + 1, top + 1) * s;
  return above * (1 - t) + below * t;
}

/** What `present` draws on a canvas of that size, by column, row and channel. */
async function presented(tracer: PathTracer, width: number, height: number) {
  const { device } = tracer;
  const texture = device.createTexture({
    size: [width, height],
    format: "rgba8unorm",
    usage: TextureUsage.RENDER_ATTACHMENT | TextureUsage.COPY_SRC,
  });
  const context = {
    getConfiguration: () => ({ device, format: "rgba8unorm" }),
    getCurrentTexture: () => texture,
  } as unknown as GPUCanvasContext;
  await expect.poll(() => tracer.present(context)).toBe(true);

  const staging = device.createBuffer({
    size: BYTES_PER_ROW * height,
    usage: BufferUsage.COPY_DST | BufferUsage.MAP_READ,
  });
  const encoder = device.createCommandEncoder();
  encoder.copyTextureToBuffer({ texture }, { buffer: staging, bytesPerRow: BYTES_PER_ROW }, [width, height]);
  device.queue.submit([encoder.finish()]);
  await staging.mapAsync(MapMode.READ);
  const bytes = new Uint8Array(staging.getMappedRange().slice(0));
  staging.destroy();
  texture.destroy();
  return (x: number, y: number, channel: number) => bytes[y * BYTES_PER_ROW + x * 4 + channel]!;
}
