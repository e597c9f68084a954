import { PathTracer } from "rt-viewer";
import { isSoftware } from "../gallery";

/** The device on which everything of this page runs. */
export type Adapter = {
  readonly device: GPUDevice;
  readonly name: string;
  /** A CPU stands in for the GPU. */
  readonly isSoftware: boolean;
};

/**
 * Opens the visitor's adapter: by a tracer of a single pixel, which asks for the features and limits that the others
 * want and lives as long as the page.
 *
 * @throws {WebGpuError} if there is no WebGPU or no adapter.
 */
export async function openAdapter(): Promise<Adapter> {
  const scene = {
    camera: { position: [0, 0, 2], target: [0, 0, 0] },
    materials: { any: {} },
    objects: [{ type: "sphere", center: [0, 0, 0], radius: 1, material: "any" }],
  } as const;
  const { device, stats } = await PathTracer.create({ scene, width: 1, height: 1, settings: { constants: false } });
  return { device, name: stats.adapter, isSoftware: isSoftware(stats.adapter) };
}
