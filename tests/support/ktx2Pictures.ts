// KTX2 files. Those in Basis Universal nothing here writes: they were made with ktx2-encoder 0.6.0 (Basis Universal 2.5), of
// `texelsOfKtx2Blocks` at its best quality (qualityLevel 255, uastcLDRQualityLevel 2), and `mixed…` of a picture of 22 × 18 texels
// with gradients, an edge and noise, so that they have blocks of many modes. `uastcZstandard` has smaller levels too.

const KTX2_PICTURES = {
  etc1s:
    "q0tUWCAyMLsNChoKAAAAAAEAAAAMAAAACgAAAAAAAAAAAAAAAQAAAAEAAAABAAAAaAAAACwAAACUAAAAJAAAALgAAAAAAAAAmgAAAAAAAABSAQAAAAAAAAUAAAAAAAAAAAAAAAAAAAAsAAAAAAAAAAIAKACjAQEAAwMAAAgAAAAAAAAAAAA/AAAAAAAAAAAA/////x8AAABLVFh3cml0ZXIAQmFzaXMgVW5pdmVyc2FsIDIuNTAAAAkAAgA6AAAACQAAAC8AAAAAAAAAAAAAAAAAAAAFAAAAAAAAAAAAAAAfQNwAAAAAQEgTrkgDiAJAAAAwBHRLP0nkA4gBAAAAAAhatzDqAJgCIAAAAACCpBH7RGJBSew7urhYBAAAAFBVVVUFAMFEAAAAAAAA8l9NAJgAAAAAAABAGAHiCAgAAAABc8lg9AQBwAQAAAAAAAACCABQ/jYyGg==",
  etc1sAlpha:
    "q0tUWCAyMLsNChoKAAAAAAEAAAAMAAAACgAAAAAAAAAAAAAAAQAAAAEAAAABAAAAaAAAADwAAACkAAAAJAAAAMgAAAAAAAAApQAAAAAAAABtAQAAAAAAAAsAAAAAAAAAAAAAAAAAAAA8AAAAAAAAAAIAOACjAQEAAwMAAAgIAAAAAAAAAAA/AAAAAAAAAAAA/////0AAPw8AAAAAAAAAAP////8fAAAAS1RYd3JpdGVyAEJhc2lzIFVuaXZlcnNhbCAyLjUwAAALAAIAPwAAAAkAAAA1AAAAAAAAAAAAAAAAAAAABQAAAAUAAAAGAAAAH0DUAAAAACCYZDtBogFEASAAABgCuqWfJPIBzAAAAAAYBGDHZ8OoA2AKgAAAAAAIkkbsUwdOKop9oakH8V8CBAAAAFBVVVUFAMGcAAEAAEAAFsr+DSzjL0wBmAIAAAAAAIE0jQBxBAYAAIaA6VUMRk8QAEwAAAAAAAAggADCMRUAI/nWirXnAA==",
  uastc:
    "q0tUWCAyMLsNChoKAAAAAAEAAAAMAAAACgAAAAAAAAAAAAAAAQAAAAEAAAAAAAAAaAAAACwAAACUAAAALAAAAAAAAAAAAAAAAAAAAAAAAADAAAAAAAAAAJAAAAAAAAAAkAAAAAAAAAAsAAAAAAAAAAIAKACmAQEAAwMAABAAAAAAAAAAAAB/AwAAAAAAAAAA/////x8AAABLVFh3cml0ZXIAQmFzaXMgVW5pdmVyc2FsIDIuNTAAAAQAAAB/fwAAV8gY4D9IGQAAAAAAAAAAAJfQWOg/iDkBAAAAAAAAAADX2JjwP8g5AgAAAAAAAAAAV4iQkDBIMQIAAAAAAAAAAJeQ0JgwiDEDAAAAAAAAAADXmBCAMMgRAAAAAAAAAAAAV0gIgBAiBAAAAAAAAAAAAJdQSIgwiCkBAAAAAAAAAADXWIiQMMgpAgAAAAAAAAAA",
  uastcZstandard:
    "q0tUWCAyMLsNChoKAAAAAAEAAAAMAAAACgAAAAAAAAAAAAAAAQAAAAQAAAACAAAAsAAAACwAAADcAAAAJAAAAAAAAAAAAAAAAAAAAAAAAAB7AQAAAAAAAGIAAAAAAAAAkAAAAAAAAAAyAQAAAAAAAEkAAAAAAAAAQAAAAAAAAAAZAQAAAAAAABkAAAAAAAAAEAAAAAAAAAAAAQAAAAAAABkAAAAAAAAAEAAAAAAAAAAsAAAAAAAAAAIAKACmAQEAAwMAABAAAAAAAAAAAAB/AwAAAAAAAAAA/////x8AAABLVFh3cml0ZXIAQmFzaXMgVW5pdmVyc2FsIDIuNTAAACi1L/0gEIEAADdyE642ktMBAAAAAAAAAAAotS/9IBCBAABAkuHP6iSzF0OIYqpiqmKqKLUv/SBAAQIAj6ID1GIR6REJl6H+4/XTUhqAJm/v7p/iAQAAAO3u/v8G0PEuxF1VIXXfgx/4gR/4HxPWAbGwldWf3+Liz8/PDyi1L/0gkM0CADQEV8gY4D9IGQCX0FjoP4g5AdfYmPA/yDkCV4iQkDBIMZeQ0JgwiDED15gQgDDIEQBXSAiAECIEl1BIiDCIKViIkDDIKQmoELasD5Bj4xCu7gGYEZhps1YU",
  mixedEtc1s:
    "q0tUWCAyMLsNChoKAAAAAAEAAAAWAAAAEgAAAAAAAAAAAAAAAQAAAAEAAAABAAAAaAAAADwAAACkAAAAJAAAAMgAAAAAAAAApQEAAAAAAABtAgAAAAAAAD4AAAAAAAAAAAAAAAAAAAA8AAAAAAAAAAIAOACjAQEAAwMAAAgIAAAAAAAAAAA/AAAAAAAAAAAA/////0AAPw8AAAAAAAAAAP////8fAAAAS1RYd3JpdGVyAEJhc2lzIFVuaXZlcnNhbCAyLjUwAAAtAC0AigAAALUAAAA+AAAAAAAAAAAAAAAAAAAAHQAAAB0AAAAhAAAAH8AjBwEAAEFCQ+yQLygQ4BGAAAyCQPWsbfUJBkKmCQJEkBAAQBAI2oZ9FzDCSQQgAgIAAIAgCBvkWgpxnb7p//jvzgdEJJ3pkEoJKK+2RI6CDaqyw0q4JINOvHWZgZJCUlUwWjJ7VONlyzpv3+A3UMe5/gWMCM2stmNmAufuO+d8YDKzAOruLwlJ/P/n56fq7++n7+3tper/X61SVVVVV1VVVVVVVVVVVUVVVVVVgCRNVQsEx/eNA8f3FYKm7xeChoYGgoaGhoeCorqiooL6r6qq8r7rlnMibxpfZjMGS9MwCGrbtsN629ractvY2NjY2Nj4/3l4cG3DOCBN0zAgr9O0BqtS/QeoUv0PCAjuDwCg6i8IAIIvCIaDLCgoeKCqKBjQMBiaVLUKAFAQACS/6UaUyyH3zENV/f/3X7UKAAHBmwABAIBB0RZqQT0sIniLtgBzAwgAEIQBoC/SOgLHAOECFgEGgDB9yRTRJV26FjN2WQAwAQAAAAAAgAACPR5pRa0jG/wajlmPMcrYJolKSuHyqVa6AE0TogAc/usXI/ze5y4W4Wzg2iozsB/ECHpFftuUS7CLJXovHQA=",
  mixedUastc:
    "q0tUWCAyMLsNChoKAAAAAAEAAAAWAAAAEgAAAAAAAAAAAAAAAQAAAAEAAAAAAAAAaAAAACwAAACUAAAALAAAAAAAAAAAAAAAAAAAAAAAAADAAAAAAAAAAOABAAAAAAAA4AEAAAAAAAAsAAAAAAAAAAIAKACmAQEAAwMAABAAAAAAAAAAAAB/AwAAAAAAAAAA/////x8AAABLVFh3cml0ZXIAQmFzaXMgVW5pdmVyc2FsIDIuNTAAAAQAAAB/fwAAk9p09oAcBIBkAHgoSgliANOK0iboTVQSGBHQ0PRdFwCP12+FyiA6/q3jND/lua59CJVSan5I0gSKjMhIjAROAHu0UmFwJ0CqBSBEdqi7/u+ThNKyqIZ5g6oNiFf9/38AUxTRfmYwFSAZQNLQ9F0XAACz0UzYGZdEQsiEPMjzjH8a0GEn79wHeiu+riY4nsEGD0FrN5kRwfE8dxzlezLPPIAw1A3k4ZWFAMiAzMKMxgibAiSA2BqjbEFE1d3u7r+7OMATG4jwjwRDyKau6mquJiBRgSLRqEvdhrmSmqOoE7kQUPHH7LJL59uyHD7Q8hg+OtAB0Hb/R9yz9AgZb27Eokgx1ARlttpoyP+EnYAZnBGPkHLmuM0y/pkPZVGpAKp+z4IGoSAwq3UFVOV5ue4NA0+iDDGHUoWXM82YdnMwfF8YkXE3ndgMeZRdGZWVHe6VCEFynPV7UundGZ3RGT2xMw+ShZV0U8WXUzMXrClJ8lwaIKIO7jqH9gYAQES0u/v/CtBRMoHuqGoKkiD5IPkg+QbQIWwlsNsOKnoKH/7hH/4g6HBPKN9ZVVH+1L7UvtS+D5AGITCZZbvvljPaJWlpaQrQgSw374ZqBrRA+0D7QPsAgdAP3GVJ31RV5u7m7ubu",
} as const;

export type Ktx2Name = keyof typeof KTX2_PICTURES;

/** A copy. */
export function ktx2Picture(name: Ktx2Name): Uint8Array<ArrayBuffer> {
  return new Uint8Array(Buffer.from(KTX2_PICTURES[name], "base64"));
}

/** Five bits of red, green and blue are what ETC1S has. Of these, both codecs lose nothing. */
const SHADES = [0, 66, 132, 198, 255];

/** 12 × 10 texels: blocks of 4 × 4 of one colour each, brighter red to the right, less green below; the upper row is opaque. */
export function texelsOfKtx2Blocks({ hasAlpha }: { readonly hasAlpha: boolean }): Uint8Array {
  const [width, height] = [12, 10];
  const texels = new Uint8Array(4 * width * height);
  for (let i = 0; i < width * height; i++) {
    const [x, y] = [(i % width) >> 2, Math.floor(i / width) >> 2];
    const alpha = hasAlpha && y > 0 ? SHADES[2]! : 255;
    texels.set([SHADES[1 + x]!, SHADES[3 - y]!, SHADES[(x + 2 * y) % 4]!, alpha], 4 * i);
  }
  return texels;
}

/** A square of that many texels in UASTC: the blocks of `mixedUastc`, again and again. */
export function tiledUastc(side: number): Uint8Array<ArrayBuffer> {
  const tile = ktx2Picture("mixedUastc");
  const start = Number(new DataView(tile.buffer).getBigUint64(80, true));
  const file = new Uint8Array(start + side * side);
  for (let to = start; to < file.length; to += tile.length - start) {
    file.set(tile.subarray(start, Math.min(tile.length, start + file.length - to)), to);
  }
  file.set(tile.subarray(0, start));
  const view = new DataView(file.buffer);
  view.setUint32(20, side, true);
  view.setUint32(24, side, true);
  for (const byte of [88, 96]) view.setBigUint64(byte, BigInt(side * side), true);
  return file;
}

type Ktx2Fields = {
  readonly vkFormat: number;
  readonly width: number;
  readonly height: number;
  readonly colorModel?: number;
  readonly supercompression?: number;
};

/** A file of one level without compression; or of another kind, of which the header says so. */
export function ktx2File(fields: Ktx2Fields, level: Uint8Array): Uint8Array<ArrayBuffer> {
  const { vkFormat, width, height, colorModel = 1, supercompression = 0 } = fields;
  const [descriptorStart, levelStart] = [104, 148];
  const file = new Uint8Array(levelStart + level.length);
  file.set([0xab, 0x4b, 0x54, 0x58, 0x20, 0x32, 0x30, 0xbb, 0x0d, 0x0a, 0x1a, 0x0a]);
  const view = new DataView(file.buffer);
  const words = [
    vkFormat,
    1,
    width,
    height,
    0,
    0,
    1,
    1,
    supercompression,
    descriptorStart,
    levelStart - descriptorStart,
  ];
  for (const [i, word] of words.entries()) view.setUint32(12 + 4 * i, word, true);
  const longs = [levelStart, level.length, level.length];
  for (const [i, long] of longs.entries()) view.setBigUint64(80 + 8 * i, BigInt(long), true);
  view.setUint32(descriptorStart, levelStart - descriptorStart, true);
  file[descriptorStart + 12] = colorModel;
  file.set(level, levelStart);
  return file;
}
