import { LoadError } from "../../errors";
import { startHost } from "./transcoderHost";

/** A KTX2 file in ETC1S or UASTC whose header was read, and its picture's size as that has it. */
export type Transcodable = {
  readonly file: Uint8Array<ArrayBuffer>;
  readonly width: number;
  readonly height: number;
};

/**
 * The texels of a file, RGBA.
 *
 * @throws {LoadError} if the file is damaged, or finds no memory. The transcoder is not to be trusted after that.
 */
export type BasisTranscoder = (file: Transcodable) => Uint8Array<ArrayBuffer>;

/** The transcoder's number for RGBA, eight bits each. */
const RGBA32 = 13;

/** It keeps the memory that the largest file takes. */
export async function createBasisTranscoder(module: WebAssembly.Module): Promise<BasisTranscoder> {
  const { call, withValues } = await startHost(module);
  call("initializeBasis");
  return ({ file, width, height }) => {
    const texels = new Uint8Array(4 * width * height);
    let isRead = false;
    try {
      withValues([file, texels], (fileValue, texelsValue) => {
        const ktx2 = call("KTX2File", fileValue!);
        isRead =
          call("KTX2File.isValid", ktx2) === 1 &&
          call("KTX2File.getImageTranscodedSizeInBytes", ktx2, 0, 0, 0, RGBA32) === texels.length &&
          call("KTX2File.startTranscoding", ktx2) === 1 &&
          // Level, layer and face 0; alpha stays alpha, and no channel is another's.
          call("KTX2File.transcodeImage", ktx2, texelsValue!, 0, 0, 0, RGBA32, 0, -1, -1) === 1;
        call("~KTX2File", ktx2);
      });
    } catch (cause) {
      throw new LoadError("its data is damaged, or takes too much memory", { cause });
    }
    if (!isRead) throw new LoadError("its data is damaged");
    return texels;
  };
}
