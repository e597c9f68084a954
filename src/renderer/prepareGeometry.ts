import type { SceneGeometry } from "../gpu/sceneGeometry";
import type { ResolvedScene } from "../scene/schema";
import type { Geometry, GeometryOptions } from "../tree/geometry";

/** A scene's geometry, and how it gets to a device. */
export type Prepared = { readonly source: Geometry; readonly upload: (device: GPUDevice) => SceneGeometry };

/** The tree's builder is a tenth of what the renderer weighs: pages whose scenes have no need of it do not load it. */
export async function prepareGeometry(scene: ResolvedScene, options: GeometryOptions): Promise<Prepared | undefined> {
  const [geometry, { SceneGeometry }] = await Promise.all([import("../tree/geometry"), import("../gpu/sceneGeometry")]);
  const source = await geometry.prepareGeometry(scene, options);
  return source && { source, upload: (device) => new SceneGeometry(device, source) };
}
