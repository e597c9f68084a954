declare module "draco3dgltf/draco3dgltf.js" {
  export const createEncoderModule: () => Promise<unknown>;
}
