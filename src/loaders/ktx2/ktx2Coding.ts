// How a KTX2 file packs its texels, of what is read, and what it is called, of what is not.
//
// [1] KTX File Format Specification, version 2.0: 3.9 supercompression schemes
// [2] Vulkan specification, VkFormat
// [3] Khronos Data Format Specification, colorModel

import { LoadError } from "../../errors";

export type Ktx2Coding =
  | { readonly kind: "etc1s" | "uastc" }
  /** As many bytes per texel. */
  | { readonly kind: "plain"; readonly channels: 1 | 2 | 3 | 4 };

const NONE = 0;
const BASIS_LZ = 1;
const ZSTANDARD = 2;
/** By number. [1] */
const SCHEMES = ["none", "BasisLZ", "Zstandard", "ZLIB"];

const UNDEFINED_FORMAT = 0;
/** R8, R8G8, R8G8B8 and R8G8B8A8, each as UNORM and as SRGB: what reads the texture decides on that. [2] */
const PLAIN_CHANNELS: Readonly<Record<number, 1 | 2 | 3 | 4>> = {
  9: 1,
  15: 1,
  16: 2,
  22: 2,
  23: 3,
  29: 3,
  37: 4,
  43: 4,
};
/** First and last VkFormat of what graphics cards unpack. [2] */
const BLOCK_FORMATS = [
  [131, 134, "BC1"],
  [135, 136, "BC2"],
  [137, 138, "BC3"],
  [139, 140, "BC4"],
  [141, 142, "BC5"],
  [143, 144, "BC6H"],
  [145, 146, "BC7"],
  [147, 152, "ETC2"],
  [153, 156, "EAC"],
  [157, 184, "ASTC"],
  [1000054000, 1000054007, "PVRTC"],
  [1000066000, 1000066013, "ASTC HDR"],
] as const;

/** Colour models. [3] */
const ETC1S = 163;
const UASTC = 166;

/**
 * @param colorModel - of the data format descriptor.
 * @param scheme - the supercompression.
 * @throws {LoadError} that says what it is, if it can't be read.
 */
export function codingOf(vkFormat: number, colorModel: number, scheme: number): Ktx2Coding {
  if (vkFormat === UNDEFINED_FORMAT && colorModel === ETC1S) {
    checkScheme("ETC1S", scheme, [BASIS_LZ]);
    return { kind: "etc1s" };
  }
  if (vkFormat === UNDEFINED_FORMAT && colorModel === UASTC) {
    checkScheme("UASTC", scheme, [NONE, ZSTANDARD]);
    return { kind: "uastc" };
  }
  const channels = PLAIN_CHANNELS[vkFormat];
  if (channels !== undefined) {
    checkScheme(`${channels} × 8 bits`, scheme, [NONE]);
    return { kind: "plain", channels };
  }
  const [, , name] = BLOCK_FORMATS.find(([first, last]) => vkFormat >= first && vkFormat <= last) ?? [];
  const number = vkFormat === UNDEFINED_FORMAT ? `colour model ${colorModel}` : `VkFormat ${vkFormat}`;
  const called = name === undefined ? number : `${name} (${number})`;
  throw new LoadError(`it is KTX2 in ${called}, which can't be read: Basis Universal (ETC1S, UASTC) and 8 bits can`);
}

function checkScheme(format: string, scheme: number, allowed: readonly number[]): void {
  if (allowed.includes(scheme)) return;
  const name = SCHEMES[scheme] ?? `number ${scheme}`;
  throw new LoadError(`it is KTX2 in ${format} with the supercompression ${name}, which can't be read`);
}
