import { LoadError } from "../../errors";
import { keep } from "../../scene/keptBytes";
import type { DecodedImage } from "../loadedScene";
import { readKtx2Header } from "./ktx2Header";
import { plainTexels } from "./plainTexels";
import type { TranscodingThread } from "./startTranscoding";

/** Decodes KTX2 pictures: as many at the same time as it is asked for. It holds workers, so it has to be disposed of. */
export class Ktx2Decoder {
  readonly #signal: AbortSignal | undefined;
  readonly #idle: TranscodingThread[] = [];
  #isDisposed = false;

  /** @param signal - ends what is decoded. */
  constructor(signal?: AbortSignal) {
    this.#signal = signal;
  }

  /** @throws {LoadError} if the file is damaged or of a kind that is not read, or the transcoder did not load. */
  async decode(bytes: Uint8Array): Promise<DecodedImage> {
    const { width, height, coding, level } = readKtx2Header(bytes);
    const texels =
      coding.kind === "plain"
        ? await plainTexels(bytes.subarray(level.start, level.end), coding.channels, this.#signal)
        : await this.#transcode(bytes.slice(), width, height);
    return { width, height, texels: keep(texels) };
  }

  /** Ends the workers, each once it has nothing to do. */
  dispose(): void {
    this.#isDisposed = true;
    for (const thread of this.#idle.splice(0)) thread.dispose();
  }

  async #transcode(file: Uint8Array<ArrayBuffer>, width: number, height: number): Promise<Uint8Array> {
    const thread = this.#idle.pop() ?? (await this.#start());
    try {
      const texels = await thread.transcode({ file, width, height }, this.#signal);
      if (this.#isDisposed) thread.dispose();
      else this.#idle.push(thread);
      return texels;
    } catch (error) {
      thread.dispose();
      throw error;
    }
  }

  async #start(): Promise<TranscodingThread> {
    try {
      const [{ compileTranscoder }, { startTranscoding }] = await Promise.all([
        import("./transcoderModule"),
        import("./startTranscoding"),
      ]);
      return await startTranscoding(await compileTranscoder(), this.#signal);
    } catch (cause) {
      this.#signal?.throwIfAborted();
      throw new LoadError(`it needs the Basis Universal transcoder, which did not load: ${cause}`, { cause });
    }
  }
}
