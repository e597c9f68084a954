import { decodeDataUri } from "./gltf/dataUri";

/** What the build makes of WebAssembly: zlib's format. Base64 hides from a server's compression what could be compressed. */
const DEFLATED = "data:application/zlib;";

/** The bytes of a file that was imported with `?url&inline`. */
export async function inlinedBytes(dataUri: string): Promise<Uint8Array<ArrayBuffer>> {
  const bytes = (await decodeDataUri(dataUri)) as Uint8Array<ArrayBuffer>;
  if (!dataUri.startsWith(DEFLATED)) return bytes;
  const inflated = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(inflated).arrayBuffer());
}
