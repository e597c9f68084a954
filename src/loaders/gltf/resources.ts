// The bytes of buffers and pictures, wherever they are: in the .glb, in the JSON, or in files of their own.

import { LoadError } from "../../errors";
import { fetchBytes } from "../fetchBytes";
import type { LoadOptions } from "../loadedScene";
import { decodeDataUri, isDataUri } from "./dataUri";
import type { GltfJson } from "./schema";

/** Reads what a glTF file is made of. */
export class Resources {
  readonly #json: GltfJson;
  readonly #binary: Uint8Array | undefined;
  readonly #options: LoadOptions;
  /** By URI: what several parts share is read once. */
  readonly #files = new Map<string, Promise<Uint8Array>>();

  constructor(json: GltfJson, binary: Uint8Array | undefined, options: LoadOptions) {
    this.#json = json;
    this.#binary = binary;
    this.#options = options;
  }

  /**
   * At least `byteLength` bytes.
   *
   * @throws {LoadError} that names the buffer and says why it can't be read.
   */
  async buffer(index: number): Promise<Uint8Array> {
    const { uri, byteLength } = this.#json.buffers[index]!;
    const path = `buffers[${index}]`;
    if (uri === undefined && this.#binary === undefined) throw new LoadError(`${path}: has no data`);
    const bytes =
      uri === undefined
        ? this.#binary!
        : await this.#file(uri).catch((cause: unknown) => {
            throw new LoadError(`${path}: ${cause instanceof Error ? cause.message : cause}`, { cause });
          });
    if (bytes.length >= byteLength) return bytes;
    throw new LoadError(`${path}: should have ${byteLength} bytes and has ${bytes.length}`);
  }

  /**
   * The bytes of a picture file; part of a larger array, maybe.
   *
   * @throws anything, which says why it can't be read and does not name it.
   */
  async image(index: number): Promise<Uint8Array> {
    const { uri, bufferView } = this.#json.images[index]!;
    if (bufferView === undefined) {
      if (uri === undefined) throw new LoadError("it has no uri and no bufferView");
      return this.#file(uri);
    }
    const view = this.#json.bufferViews[bufferView]!;
    const bytes = await this.buffer(view.buffer);
    return bytes.subarray(view.byteOffset, view.byteOffset + view.byteLength);
  }

  #file(uri: string): Promise<Uint8Array> {
    const known = this.#files.get(uri);
    if (known !== undefined) return known;
    const bytes = this.#read(uri);
    this.#files.set(uri, bytes);
    return bytes;
  }

  async #read(uri: string): Promise<Uint8Array> {
    if (isDataUri(uri)) return decodeDataUri(uri);
    const { baseUrl, fetchResource = fetchBytes, signal } = this.#options;
    return fetchResource(baseUrl === undefined ? uri : new URL(uri, baseUrl).href, signal);
  }
}
