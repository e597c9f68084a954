// What the header of a KTX2 file says, checked against the bytes that are there.
//
// [1] KTX File Format Specification, version 2.0: 3 header and level index, 3.10 data format descriptor

import { LoadError } from "../../errors";
import { codingOf, type Ktx2Coding } from "./ktx2Coding";

/** A picture: one level, one layer, one face. Smaller levels that may follow are not read. */
export type Ktx2Header = {
  readonly width: number;
  readonly height: number;
  readonly coding: Ktx2Coding;
  /** Where its largest level is: from byte `start` to before byte `end`. */
  readonly level: { readonly start: number; readonly end: number };
};

export const KTX2_MIME_TYPE = "image/ktx2";

const IDENTIFIER = [0xab, 0x4b, 0x54, 0x58, 0x20, 0x32, 0x30, 0xbb, 0x0d, 0x0a, 0x1a, 0x0a];
/** With the place of the largest level, which comes first. */
const HEADER_BYTES = 104;
const COLOR_MODEL_BYTE = 12;

export function isKtx2(bytes: Uint8Array): boolean {
  return IDENTIFIER.every((byte, i) => bytes[i] === byte);
}

/** @throws {LoadError} if it is no single 2D picture, is in a format that is not read, or lacks bytes that it should have. */
export function readKtx2Header(bytes: Uint8Array): Ktx2Header {
  if (bytes.length < HEADER_BYTES) throw new LoadError("it is cut off");
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const at = (byte: number) => view.getUint32(byte, true);
  const [width, height, depth, layers, faces] = [at(20), at(24), at(28), at(32), at(36)];
  const kind = shapeOf(height, depth, layers, faces);
  if (kind !== undefined) throw new LoadError(`it is KTX2 with ${kind}, which can't be read`);
  if (width === 0 || faces !== 1) throw new LoadError("its header is damaged");

  const descriptor = { start: at(48), end: at(48) + at(52) };
  const isDescribed = descriptor.end - descriptor.start > COLOR_MODEL_BYTE && descriptor.end <= bytes.length;
  if (!isDescribed) throw new LoadError("its header is damaged");
  const vkFormat = at(12);
  const coding = codingOf(vkFormat, view.getUint8(descriptor.start + COLOR_MODEL_BYTE), at(44));

  const level = rangeAt(view, 80);
  const [levelBytes, unpackedBytes] = [level.end - level.start, long(view, 96)];
  if (level.end > bytes.length) throw new LoadError("it is cut off");
  const isWhole = {
    etc1s: () => levelBytes > 0 && rangeAt(view, 64).end <= bytes.length,
    uastc: () => (at(44) === 0 ? levelBytes : unpackedBytes) === 16 * Math.ceil(width / 4) * Math.ceil(height / 4),
    plain: () => coding.kind === "plain" && levelBytes === coding.channels * width * height,
  };
  if (!isWhole[coding.kind]()) throw new LoadError(`its data is not what ${width} × ${height} texels have`);
  return { width, height, coding, level };
}

/** What it is, if it is no single 2D picture. */
function shapeOf(height: number, depth: number, layers: number, faces: number): string | undefined {
  if (depth > 0) return "a 3D texture";
  if (height === 0) return "a 1D texture";
  if (faces === 6) return "a cube map";
  if (layers > 1) return `an array of ${layers} pictures`;
  return undefined;
}

function rangeAt(view: DataView, byte: number): { readonly start: number; readonly end: number } {
  const start = long(view, byte);
  return { start, end: start + long(view, byte + 8) };
}

/** Past 2⁵³ not exact, but then larger than any file. */
function long(view: DataView, byte: number): number {
  return Number(view.getBigUint64(byte, true));
}
