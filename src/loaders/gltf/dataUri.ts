import { LoadError } from "../../errors";
import { nextTask } from "../../nextTask";

/** Characters that are decoded in one task: they take a few milliseconds. */
const SLICE_LENGTH = 2 ** 20;

const [SPACE, PADDING] = [64, 65];
/** What a character stands for, by its code. */
const VALUES: readonly (number | undefined)[] = (() => {
  const values: (number | undefined)[] = [];
  const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (const [value, digit] of [...digits].entries()) values[digit.charCodeAt(0)] = value;
  for (const space of " \t\n\f\r") values[space.charCodeAt(0)] = SPACE;
  values["=".charCodeAt(0)] = PADDING;
  return values;
})();

/** Whether a URI has the data within. Schemes have no case. */
export function isDataUri(uri: string): boolean {
  return /^data:/i.test(uri);
}

/**
 * The bytes of a data URI in base64, a word without case. Decoded here and not by `fetch`, which a page's content security policy may keep from
 * `data:`, nor by `atob`, which gives a text, all at once, and in Node takes seconds for a megabyte.
 *
 * @throws {LoadError} if it is none.
 */
export async function decodeDataUri(uri: string): Promise<Uint8Array> {
  const comma = uri.indexOf(",");
  if (comma < 0 || !/;\s*base64\s*$/i.test(uri.slice(0, comma))) throw new LoadError("expected a data URI in base64");
  const bytes = new Uint8Array(Math.ceil(((uri.length - comma) * 3) / 4));
  let length = 0;
  let bits = 0;
  let bitCount = 0;
  let hasEnded = false;
  for (let start = comma + 1; start < uri.length; start += SLICE_LENGTH) {
    if (start > comma + 1) await nextTask();
    const end = Math.min(start + SLICE_LENGTH, uri.length);
    for (let i = start; i < end; i++) {
      const value = VALUES[uri.charCodeAt(i)];
      if (value === SPACE) continue;
      if (value === undefined || (hasEnded && value !== PADDING)) throw new LoadError("its data URI is not base64");
      if (value === PADDING) {
        hasEnded = true;
        continue;
      }
      bits = ((bits << 6) | value) & 0xfff;
      bitCount += 6;
      if (bitCount < 8) continue;
      bitCount -= 8;
      bytes[length++] = bits >> bitCount;
    }
  }
  if (bitCount === 6) throw new LoadError("its data URI is not base64"); // it ends within a byte
  return bytes.subarray(0, length);
}
