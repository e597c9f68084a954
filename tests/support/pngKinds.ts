import { CHANNELS, type PngKind, pngOf } from "./png";
import { createRandom } from "./random";

export type PngCase = { readonly name: string; readonly file: Uint8Array; readonly texels: Uint8Array };

/** PNG files of every depth and colour type, transparent parts and interlacing, and what their texels are. */
export function pngCases(seed: number): PngCase[] {
  const random = createRandom(seed);
  const depths = { 0: [1, 2, 4, 8, 16], 2: [8, 16], 3: [1, 2, 4, 8], 4: [8, 16], 6: [8, 16] } as const;
  const cases: PngCase[] = [];
  for (const colorType of [0, 2, 3, 4, 6] as const) {
    for (const depth of depths[colorType]) {
      for (const isInterlaced of [false, true]) {
        for (const isTransparent of colorType < 4 ? [false, true] : [false]) {
          const kind: PngKind = { width: 13, height: 11, depth, colorType, isInterlaced };
          const values = Array.from({ length: 13 * 11 * CHANNELS[colorType] }, () => Math.floor(2 ** depth * random()));
          const whole = { ...kind, ...extrasOf(kind, values, isTransparent, random) };
          const name = `colour type ${colorType}, ${depth} bits${isInterlaced ? ", interlaced" : ""}${isTransparent ? ", tRNS" : ""}`;
          cases.push({ name, file: pngOf(whole, values), texels: texelsOf(whole, values) });
        }
      }
    }
  }
  return cases;
}

/** A palette; and as transparent the first three of its numbers, or the fourth texel. */
function extrasOf(
  { depth, colorType }: PngKind,
  values: readonly number[],
  isTransparent: boolean,
  random: () => number,
): Partial<PngKind> {
  const palette = Array.from({ length: 3 * 2 ** Math.min(depth, 8) }, () => Math.floor(256 * random()));
  const texel = values.slice(3 * CHANNELS[colorType], 4 * CHANNELS[colorType]);
  const key = texel.flatMap((value) => [value >> 8, value & 255]);
  const transparency = colorType === 3 ? [0, 100, 200].slice(0, 2 ** depth) : key;
  return { ...(colorType === 3 && { palette }), ...(isTransparent && { transparency }) };
}

function texelsOf({ depth, colorType, palette, transparency }: PngKind, values: readonly number[]): Uint8Array {
  const channels = CHANNELS[colorType];
  // Less than eight bits are spread over all bytes, of sixteen the upper eight are kept, as Chromium does it.
  const byteOf = (value: number) => (depth === 16 ? value >> 8 : (value * 255) / (2 ** depth - 1));
  const key = Array.from(
    { length: channels },
    (_, i) => 256 * (transparency?.[2 * i] ?? Number.NaN) + (transparency?.[2 * i + 1] ?? 0),
  );
  const texels: number[] = [];
  for (let i = 0; i < values.length; i += channels) {
    const texel = values.slice(i, i + channels);
    if (palette !== undefined) {
      texels.push(...palette.slice(3 * texel[0]!, 3 * texel[0]! + 3), transparency?.[texel[0]!] ?? 255);
    } else {
      const color = channels < 3 ? [texel[0]!, texel[0]!, texel[0]!] : texel.slice(0, 3);
      const isKey = key.every((value, channel) => value === texel[channel]);
      texels.push(...color.map(byteOf), channels % 2 === 0 ? byteOf(texel.at(-1)!) : isKey ? 0 : 255);
    }
  }
  return Uint8Array.from(texels);
}
