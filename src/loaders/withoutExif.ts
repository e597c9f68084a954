// Picture files without Exif metadata, which can say that a picture is turned. glTF wants texels as they are stored, and Chromium
// turns them even with `imageOrientation: "none"`.

/**
 * The parts of a picture file that make a blob of it without its Exif metadata. Nothing is copied.
 *
 * @param mimeType - files other than JPEG, PNG and WebP are given back as they are.
 */
export function withoutExif(bytes: Uint8Array<ArrayBuffer>, mimeType: string): BlobPart[] {
  const find = FINDERS[mimeType];
  const range = find?.(bytes, new DataView(bytes.buffer, bytes.byteOffset, bytes.length));
  if (range === undefined) return [bytes];
  const { start, end, instead } = range;
  return [bytes.subarray(0, start), instead ?? "", bytes.subarray(end)];
}

type Range = { readonly start: number; readonly end: number; readonly instead?: string };
type Finder = (bytes: Uint8Array, view: DataView) => Range | undefined;

const FINDERS: Readonly<Record<string, Finder>> = {
  "image/jpeg": exifOfJpeg,
  "image/png": exifOfPng,
  "image/webp": exifOfWebp,
};

const isAt = (bytes: Uint8Array, at: number, text: string) =>
  [...text].every((character, i) => bytes[at + i] === character.charCodeAt(0));

/** A segment before the scan: 0xff, its marker, and how long it is without those two. */
function exifOfJpeg(bytes: Uint8Array, view: DataView): Range | undefined {
  for (let start = 2; start + 4 <= bytes.length && bytes[start] === 0xff; ) {
    const marker = bytes[start + 1];
    if (marker === 0xff)
      start++; // a filler
    else if (marker === 0xda) return undefined;
    else {
      const end = start + 2 + view.getUint16(start + 2);
      if (marker === 0xe1 && isAt(bytes, start + 4, "Exif\0")) return { start, end };
      start = end;
    }
  }
  return undefined;
}

/** A chunk: how long its data is, its name, the data, a checksum. */
function exifOfPng(bytes: Uint8Array, view: DataView): Range | undefined {
  for (let start = 8; start + 12 <= bytes.length; ) {
    const end = start + 12 + view.getUint32(start);
    if (isAt(bytes, start + 4, "eXIf")) return { start, end };
    start = end;
  }
  return undefined;
}

/** A chunk: its name, how long its data is, the data, a byte if that is odd. With another name decoders pass over it. */
function exifOfWebp(bytes: Uint8Array, view: DataView): Range | undefined {
  for (let start = 12; start + 8 <= bytes.length; ) {
    if (isAt(bytes, start, "EXIF")) return { start, end: start + 4, instead: "none" };
    const length = view.getUint32(start + 4, true);
    start += 8 + length + (length % 2);
  }
  return undefined;
}
