/** What a link to the playground carries. */
export type Shared = {
  /** The editor's text, whether or not it is a scene. */
  readonly text: string;
  /** Of the picture, in stops. */
  readonly exposure: number;
};

/** A scene that fits no link, or a link that holds no scene. The message is for the visitor. */
export class LinkError extends Error {
  override readonly name = "LinkError";
}

// Longer addresses are cut short by programs that pass them on.
const MAX_LINK_LENGTH = 16_000;
// A short link can unpack to a thousand times its length; no scene that was packed here is longer than this.
const MAX_TEXT_BYTES = 1 << 20;

/**
 * The part of an address, from `#`, that holds a text: deflated, as base64url.
 *
 * @throws {LinkError} if it gets too long.
 */
export async function toHash({ text, exposure }: Shared): Promise<string> {
  const packed = await readAll(new Blob([text]).stream().pipeThrough(new CompressionStream("deflate-raw")));
  const hash = `#scene=${toBase64Url(packed)}${exposure === 0 ? "" : `&exposure=${exposure}`}`;
  if (hash.length <= MAX_LINK_LENGTH) return hash;
  const lengths = `${hash.length.toLocaleString("en")} characters; ${MAX_LINK_LENGTH.toLocaleString("en")} is the limit`;
  throw new LinkError(`The scene is too long for a link: ${lengths}. Send the text itself.`);
}

/**
 * Reads what `toHash` wrote.
 *
 * @returns `undefined` if the hash does not speak of a scene.
 * @throws {LinkError} if it does, and holds none.
 */
export async function fromHash(hash: string): Promise<Shared | undefined> {
  const fields = new URLSearchParams(hash.slice(1));
  const packed = fields.get("scene");
  if (packed === null) return undefined;
  if (hash.length > MAX_LINK_LENGTH) throw new LinkError("This link is too long to be one of ours.");
  try {
    const stream = new Blob([fromBase64Url(packed)]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
    const text = new TextDecoder("utf-8", { fatal: true }).decode(await readAll(stream, MAX_TEXT_BYTES));
    const exposure = Number(fields.get("exposure"));
    return { text, exposure: Math.abs(exposure) <= 32 ? exposure : 0 };
  } catch {
    throw new LinkError("This link holds no scene; it may have been cut short.");
  }
}

/** @throws {RangeError} past `maxBytes`. */
async function readAll(stream: ReadableStream<Uint8Array>, maxBytes = Number.POSITIVE_INFINITY) {
  const reader = stream.getReader();
  const chunks: Uint8Array<ArrayBuffer>[] = [];
  let byteCount = 0;
  for (let read = await reader.read(); !read.done; read = await reader.read()) {
    byteCount += read.value.length;
    if (byteCount > maxBytes) {
      await reader.cancel();
      throw new RangeError(`more than ${maxBytes} bytes`);
    }
    chunks.push(new Uint8Array(read.value));
  }
  return new Uint8Array(await new Blob(chunks).arrayBuffer());
}

function toBase64Url(bytes: Uint8Array): string {
  const binary = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** @throws {DOMException} if it is not base64url. */
function fromBase64Url(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(binary, (character) => character.charCodeAt(0));
}
