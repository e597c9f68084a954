import { nextTask } from "../../nextTask";

/** Texels that are copied in one task: they take a few milliseconds. */
const SLICE_TEXELS = 2 ** 20;

/**
 * Texels of one to four bytes as RGBA, a slice in each task. What a texel lacks is as graphics cards have it: green and blue are 0,
 * alpha is 255.
 *
 * @param bytes - `channels` per texel.
 */
export async function plainTexels(
  bytes: Uint8Array,
  channels: 1 | 2 | 3 | 4,
  signal?: AbortSignal,
): Promise<Uint8Array<ArrayBuffer>> {
  const count = bytes.length / channels;
  const texels = new Uint8Array(4 * count);
  for (let start = 0; start < count; start += SLICE_TEXELS) {
    const end = Math.min(count, start + SLICE_TEXELS);
    if (channels === 4) texels.set(bytes.subarray(4 * start, 4 * end), 4 * start);
    else {
      for (let i = start; i < end; i++) {
        for (let channel = 0; channel < channels; channel++) texels[4 * i + channel] = bytes[channels * i + channel]!;
        texels[4 * i + 3] = 255;
      }
    }
    await nextTask();
    signal?.throwIfAborted();
  }
  return texels;
}
