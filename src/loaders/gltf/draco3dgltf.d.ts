declare module "draco3dgltf/draco_decoder_gltf_nodejs.js" {
  /** Compiles the decoder. Rejects, or never settles, without WebAssembly. */
  const createDecoderModule: (options: {
    readonly wasmBinary?: Uint8Array;
    readonly locateFile?: (name: string) => string;
  }) => Promise<unknown>;
  export default createDecoderModule;
}
