import { afterAll, describe, expect, test } from "vitest";
import { LoadError } from "../../../../src/errors";
import { Ktx2Decoder } from "../../../../src/loaders/ktx2/ktx2Decoder";
import { transcodeByScript } from "../../../support/basisScript";
import { type Ktx2Name, ktx2File, ktx2Picture, texelsOfKtx2Blocks } from "../../../support/ktx2Pictures";
import { createRandom } from "../../../support/random";

const decoder = new Ktx2Decoder();
afterAll(() => decoder.dispose());

const NAMES = ["etc1s", "etc1sAlpha", "uastc", "uastcZstandard", "mixedEtc1s", "mixedUastc"] as const;

describe("Basis Universal", () => {
  test.each(["etc1s", "etc1sAlpha", "uastc", "uastcZstandard"] as const)(
    "%s is what was encoded, of which it can hold every colour",
    async (name) => {
      const { width, height, texels } = await decoder.decode(ktx2Picture(name));
      expect([width, height]).toEqual([12, 10]);
      expect([...texels]).toEqual([...texelsOfKtx2Blocks({ hasAlpha: name !== "etc1s" })]);
    },
  );

  test.each(["mixedEtc1s", "mixedUastc"] as const)("%s has the texels that Binomial's script gives", async (name) => {
    const { width, height, texels } = await decoder.decode(ktx2Picture(name));
    expect([width, height]).toEqual([22, 18]);
    expect([...texels]).toEqual([...(await transcodeByScript(ktx2Picture(name)))]);
  });

  test("several at the same time do not mix", async () => {
    const decoded = await Promise.all(NAMES.map((name) => decoder.decode(ktx2Picture(name))));
    for (const [i, name] of NAMES.entries()) {
      expect([...decoded[i]!.texels], name).toEqual([...(await decoder.decode(ktx2Picture(name))).texels]);
    }
  });

  test("a file within a larger one is read from where it starts", async () => {
    const file = ktx2Picture("uastc");
    const larger = new Uint8Array(file.length + 50);
    larger.set(file, 13);
    const { texels } = await decoder.decode(larger.subarray(13, 13 + file.length));
    expect([...texels]).toEqual([...texelsOfKtx2Blocks({ hasAlpha: true })]);
    expect(larger.subarray(13, 13 + file.length)).toEqual(file); // it is not given away
  });
});

describe("eight bits without compression", () => {
  test.each([
    [9, 1],
    [15, 1],
    [16, 2],
    [22, 2],
    [23, 3],
    [29, 3],
    [37, 4],
    [43, 4],
  ])("VkFormat %i has %i channels; what it lacks is 0, and alpha 255", async (vkFormat, channels) => {
    const [width, height] = [5, 3];
    const level = Uint8Array.from({ length: channels * width * height }, (_, i) => 7 * i);
    const { texels } = await decoder.decode(ktx2File({ vkFormat, width, height }, level));
    const expected = Array.from({ length: 4 * width * height }, (_, i) => {
      const [texel, channel] = [i >> 2, i & 3];
      if (channel < channels) return level[channels * texel + channel]!;
      return channel === 3 ? 255 : 0;
    });
    expect([...texels]).toEqual(expected);
  });

  test("more texels than one task copies are all there", async () => {
    const [width, height] = [2 ** 11, 2 ** 9 + 3];
    const level = Uint8Array.from({ length: width * height }, (_, i) => i >> 8);
    const { texels } = await decoder.decode(ktx2File({ vkFormat: 9, width, height }, level));
    const red = new Uint8Array(texels).filter((_, i) => i % 4 === 0);
    expect(Buffer.compare(red, level)).toBe(0);
  });
});

describe("a file that can't be read is an error that says why", () => {
  const flat = { vkFormat: 37, width: 2, height: 2 };
  const changed = (file: Uint8Array, ...changes: readonly (readonly [byte: number, word: number])[]) => {
    const view = new DataView(file.buffer);
    for (const [byte, word] of changes) view.setUint32(byte, word, true);
    return file;
  };
  const plain = (...changes: readonly (readonly [number, number])[]) =>
    changed(ktx2File(flat, new Uint8Array(16)), ...changes);
  const basis = (name: Ktx2Name, ...changes: readonly (readonly [number, number])[]) =>
    changed(ktx2Picture(name), ...changes);

  const cases: Readonly<Record<string, readonly [Uint8Array, string]>> = {
    "nothing but its first bytes": [plain().subarray(0, 12), "it is cut off"],
    "a 3D texture": [plain([28, 4]), "it is KTX2 with a 3D texture, which can't be read"],
    "a 1D texture": [plain([24, 0]), "it is KTX2 with a 1D texture, which can't be read"],
    "an array": [plain([32, 7]), "it is KTX2 with an array of 7 pictures, which can't be read"],
    "a cube map": [plain([36, 6]), "it is KTX2 with a cube map, which can't be read"],
    "no face": [plain([36, 0]), "its header is damaged"],
    "no column": [plain([20, 0]), "its header is damaged"],
    "a descriptor past its end": [plain([48, 1e9]), "its header is damaged"],
    "no descriptor": [plain([52, 0]), "its header is damaged"],
    BC7: [
      plain([12, 145]),
      "it is KTX2 in BC7 (VkFormat 145), which can't be read: Basis Universal (ETC1S, UASTC) and 8 bits can",
    ],
    "sixteen bits": [
      plain([12, 91]),
      "it is KTX2 in VkFormat 91, which can't be read: Basis Universal (ETC1S, UASTC) and 8 bits can",
    ],
    "UASTC HDR": [
      ktx2File({ ...flat, vkFormat: 0, colorModel: 167 }, new Uint8Array(16)),
      "it is KTX2 in colour model 167, which can't be read: Basis Universal (ETC1S, UASTC) and 8 bits can",
    ],
    "eight bits in Zstandard": [
      plain([44, 2]),
      "it is KTX2 in 4 × 8 bits with the supercompression Zstandard, which can't be read",
    ],
    "UASTC in ZLIB": [
      basis("uastc", [44, 3]),
      "it is KTX2 in UASTC with the supercompression ZLIB, which can't be read",
    ],
    "an unknown supercompression": [
      basis("etc1s", [44, 77]),
      "it is KTX2 in ETC1S with the supercompression number 77, which can't be read",
    ],
    "a level past its end": [plain([80, 140], [88, 200]), "it is cut off"],
    "a level past 2⁶³": [plain([84, 0xffffffff]), "it is cut off"],
    "fewer texels than it says": [plain([24, 3]), "its data is not what 2 × 3 texels have"],
    "a hundred bytes that say 16384 × 16384": [
      basis("uastc", [20, 16384], [24, 16384]),
      "its data is not what 16384 × 16384 texels have",
    ],
    "as much in Zstandard": [
      basis("uastcZstandard", [20, 16384], [24, 16384]),
      "its data is not what 16384 × 16384 texels have",
    ],
    "Zstandard that unpacks to less": [
      basis("uastcZstandard", [20, 512], [24, 512], [96, 2 ** 18]),
      "its data is damaged",
    ],
    "ETC1S without its tables": [basis("etc1s", [64, 1e9]), "its data is not what 12 × 10 texels have"],
  };
  test.each(Object.keys(cases))("%s", async (name) => {
    const [file, message] = cases[name]!;
    const error: unknown = await decoder.decode(file).catch((error: unknown) => error);
    expect(error).toBeInstanceOf(LoadError);
    expect((error as LoadError).message).toBe(message);
  });

  test.each(NAMES)("%s, cut off anywhere", async (name) => {
    const file = ktx2Picture(name);
    for (let length = 12; length < file.length; length += 7) {
      await expect(decoder.decode(file.slice(0, length)), `${length} bytes`).rejects.toBeInstanceOf(LoadError);
    }
    await decoder.decode(file);
  });

  test("or else has all its texels, whatever bytes are changed, seed 8", async () => {
    const random = createRandom(8);
    const most = 2 ** 20; // texels: it may say more, which takes its time
    for (const name of NAMES) {
      const texels = [...(await decoder.decode(ktx2Picture(name))).texels];
      for (let i = 0; i < 12; i++) {
        const file = ktx2Picture(name);
        for (let change = 0; change < 3; change++)
          file[12 + Math.floor((file.length - 12) * random())] = 256 * random();
        const view = new DataView(file.buffer);
        if (view.getUint32(20, true) * view.getUint32(24, true) > most) continue;
        const image = await decoder.decode(file).catch((error: unknown) => error);
        if (image instanceof LoadError) continue;
        const { width, height, texels } = image as Awaited<ReturnType<Ktx2Decoder["decode"]>>;
        expect(texels.length).toBe(4 * width * height);
      }
      expect([...(await decoder.decode(ktx2Picture(name))).texels], name).toEqual(texels);
    }
  });
});
