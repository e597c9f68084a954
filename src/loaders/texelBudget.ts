import type { LoadOptions } from "./loadedScene";
import { CERTAIN_TEXEL_BYTES, MAX_TEXEL_BYTES } from "./pictureLimits";

/**
 * How many bytes the textures of a file may have.
 *
 * @param wanted - how many they have. An adapter is asked only for what not every device can hold.
 */
export async function texelBudget(wanted: number, { maxTexelBytes }: LoadOptions): Promise<number> {
  if (maxTexelBytes !== undefined) return maxTexelBytes;
  if (wanted <= CERTAIN_TEXEL_BYTES) return CERTAIN_TEXEL_BYTES;
  // As `openDevice` asks for one, which opens the device with these limits.
  const adapter = await globalThis.navigator?.gpu
    ?.requestAdapter({ powerPreference: "high-performance" })
    .catch(() => null);
  return adapter ? texelBytesWithin(adapter.limits) : CERTAIN_TEXEL_BYTES;
}

/** How many bytes of texels an adapter or device can hold, as far as memory should be taken for them. */
export function texelBytesWithin({ maxStorageBufferBindingSize, maxBufferSize }: GPUSupportedLimits): number {
  return Math.min(maxStorageBufferBindingSize, maxBufferSize, MAX_TEXEL_BYTES);
}
