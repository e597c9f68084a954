import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";

const { resolve } = createRequire(import.meta.url);
const folder = "three/examples/jsm/libs/basis/";

/** The script that comes with the transcoder, as text. */
export const readBasisScript = () => readFile(resolve(`${folder}basis_transcoder.js`), "utf8");

type BasisModule = {
  readonly initializeBasis: () => void;
  readonly KTX2File: new (
    file: Uint8Array,
  ) => {
    readonly getImageTranscodedSizeInBytes: (level: number, layer: number, face: number, format: number) => number;
    readonly startTranscoding: () => number;
    readonly transcodeImage: (texels: Uint8Array, ...options: number[]) => number;
  };
};

/** The texels of a KTX2 file, RGBA, as that script has them. It makes functions of text, which is why the package has none of it. */
export async function transcodeByScript(file: Uint8Array): Promise<Uint8Array> {
  const module = { exports: undefined as unknown };
  new Function("module", "exports", "process", await readBasisScript())(module, {}, undefined);
  const create = module.exports as (options: { wasmBinary: Uint8Array }) => Promise<BasisModule>;
  const basis = await create({ wasmBinary: await readFile(resolve(`${folder}basis_transcoder.wasm`)) });
  basis.initializeBasis();
  const RGBA32 = 13;
  const ktx2 = new basis.KTX2File(file);
  const texels = new Uint8Array(ktx2.getImageTranscodedSizeInBytes(0, 0, 0, RGBA32));
  ktx2.startTranscoding();
  ktx2.transcodeImage(texels, 0, 0, 0, RGBA32, 0, -1, -1);
  return texels;
}
