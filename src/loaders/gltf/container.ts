// What a glTF file is made of: the JSON, and the binary chunk that a .glb carries beside it.
//
// [1] glTF 2.0 specification, 4.4: binary glTF layout

import { LoadError } from "../../errors";

export type Container = {
  readonly json: unknown;
  /** The data of the buffer that has no URI. */
  readonly binary?: Uint8Array;
};

const HEADER_BYTES = 12;
const CHUNK_HEADER_BYTES = 8;
const MAGIC = 0x46546c67; // "glTF"
const JSON_CHUNK = 0x4e4f534a;
const BINARY_CHUNK = 0x004e4942;

/** Whether a file begins as a .glb does. */
export function isGlb(bytes: Uint8Array): boolean {
  return bytes.length >= 4 && viewOf(bytes).getUint32(0, true) === MAGIC;
}

/**
 * Takes a .glb or .gltf file apart. Nothing is copied.
 *
 * @throws {LoadError} if it is cut off, or its lengths contradict each other.
 */
export function readContainer(bytes: Uint8Array): Container {
  if (!isGlb(bytes)) return { json: parseJson(bytes) };
  if (bytes.length < HEADER_BYTES + CHUNK_HEADER_BYTES) {
    throw new LoadError(`is cut off after ${bytes.length} bytes, within its header`);
  }
  const view = viewOf(bytes);
  const version = view.getUint32(4, true);
  if (version !== 2) throw new LoadError(`is glTF of version ${version}; only version 2 can be read`);
  const length = view.getUint32(8, true);
  if (length > bytes.length) throw new LoadError(`is cut off: it should have ${length} bytes and has ${bytes.length}`);

  const text = chunkAt(bytes, HEADER_BYTES, length);
  if (text.type !== JSON_CHUNK) throw new LoadError("byte 16: expected a JSON chunk");
  const json = parseJson(text.data);
  if (text.end + CHUNK_HEADER_BYTES > length) return { json };
  const next = chunkAt(bytes, text.end, length);
  return next.type === BINARY_CHUNK ? { json, binary: next.data } : { json };
}

function chunkAt(bytes: Uint8Array, start: number, fileEnd: number) {
  const view = viewOf(bytes);
  const dataStart = start + CHUNK_HEADER_BYTES;
  const end = dataStart + view.getUint32(start, true);
  if (end > fileEnd) {
    throw new LoadError(`byte ${start}: a chunk of ${end - dataStart} bytes goes ${end - fileEnd} past the end`);
  }
  return { type: view.getUint32(start + 4, true), data: bytes.subarray(dataStart, end), end };
}

function parseJson(bytes: Uint8Array): unknown {
  try {
    return JSON.parse(new TextDecoder().decode(bytes));
  } catch (cause) {
    throw new LoadError(`is not JSON: ${cause instanceof Error ? cause.message : cause}`, { cause });
  }
}

function viewOf(bytes: Uint8Array): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}
