import type { Extension } from "@gltf-transform/core";
import { LoadError } from "../../errors";
import { inlinedBytes } from "../inlinedBytes";

/** The Draco decoder, for `KHR_draco_mesh_compression`: a quarter of a megabyte that most files don't need. */
export async function loadDraco() {
  try {
    const [{ KHRDracoMeshCompression }, { default: createDecoderModule }, { default: wasm }] = await Promise.all([
      import("@gltf-transform/extensions"),
      import("draco3dgltf/draco_decoder_gltf_nodejs.js"),
      import("draco3dgltf/draco_decoder_gltf.wasm?url&inline"),
    ]);
    // A new one for every file: after damaged data its memory is not to be trusted.
    const decoder = await createDecoderModule({ wasmBinary: await inlinedBytes(wasm) });
    return { extension: KHRDracoMeshCompression as typeof Extension, dependency: { "draco3d.decoder": decoder } };
  } catch (cause) {
    throw new LoadError(`needs the Draco decoder, which did not load: ${cause}`, { cause });
  }
}
