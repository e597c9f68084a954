import type { Extension } from "@gltf-transform/core";
import { LoadError } from "../../errors";

/** The decoder for `EXT_meshopt_compression`. */
export async function loadMeshopt() {
  try {
    const [{ EXTMeshoptCompression }, { MeshoptDecoder }] = await Promise.all([
      import("@gltf-transform/extensions"),
      import("meshoptimizer/decoder"),
    ]);
    await MeshoptDecoder.ready;
    return { extension: EXTMeshoptCompression as typeof Extension, dependency: { "meshopt.decoder": MeshoptDecoder } };
  } catch (cause) {
    throw new LoadError(`needs the meshopt decoder, which did not load: ${cause}`, { cause });
  }
}
