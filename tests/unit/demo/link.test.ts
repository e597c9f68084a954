import { deflateRawSync } from "node:zlib";
import { describe, expect, test } from "vitest";
import { fromHash, LinkError, toHash } from "../../../demo/playground/link";

describe("a playground link", () => {
  test("gives back the text and the exposure, whatever is in it", async () => {
    const shared = { text: '{ "materials": { "Größe 🌍": {} } }\n'.repeat(20), exposure: -1.5 };
    const hash = await toHash(shared);
    expect(hash).toMatch(/^#scene=[\w-]+&exposure=-1\.5$/);
    expect(await fromHash(hash)).toEqual(shared);
  });

  test("is absent from an address that speaks of something else", async () => {
    expect(await fromHash("")).toBeUndefined();
    expect(await fromHash("#main")).toBeUndefined();
  });

  test("is refused where it would be too long to be passed on, seed 1", async () => {
    let state = 1;
    const noise = Array.from({ length: 20_000 }, () => {
      state = (state * 48271) % 2147483647;
      return String.fromCharCode(33 + (state % 90));
    }).join("");
    await expect(toHash({ text: noise, exposure: 0 })).rejects.toThrow(
      /too long for a link: \d\d,\d\d\d characters; 16,000/,
    );
  });

  const packed = (bytes: Uint8Array) => `#scene=${deflateRawSync(bytes).toString("base64url")}`;
  test.each([
    ["no base64", "#scene=%00<script>"],
    ["not deflated", "#scene=AAAA"],
    ["empty", "#scene="],
    ["cut short", packed(new TextEncoder().encode("{}".repeat(400))).slice(0, -2)],
    ["not UTF-8", packed(new Uint8Array([0xff, 0xfe, 0xfd]))],
    ["a megabyte and more once unpacked", packed(new Uint8Array((1 << 20) + 1))],
    ["longer than any of ours", `#scene=${"A".repeat(16_001)}`],
  ])("that is %s is an error for the visitor", async (_, hash) => {
    await expect(fromHash(hash)).rejects.toThrow(LinkError);
  });

  test("with an exposure that is none has none", async () => {
    const hash = await toHash({ text: "{}", exposure: 0 });
    for (const exposure of ["1e9", "NaN", "<b>"]) {
      expect(await fromHash(`${hash}&exposure=${exposure}`)).toEqual({ text: "{}", exposure: 0 });
    }
  });
});
