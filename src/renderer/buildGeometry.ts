import type { SceneGeometry } from "../gpu/sceneGeometry";
import type { ResolvedScene } from "../scene/schema";
import { needsGeometry } from "../tree/boundedShapes";
import type { Geometry, GeometryOptions } from "../tree/geometry";

/** A scene's geometry, and how it gets to a device. */
export type BuiltGeometry = { readonly source: Geometry; readonly upload: (device: GPUDevice) => SceneGeometry };

/**
 * Sorts the geometry of a scene.
 *
 * @returns undefined, and no promise, for a scene that has none: it is not to wait for so much as a turn of the event loop.
 * @throws the reason of the options' signal.
 */
export function buildGeometry(
  scene: ResolvedScene,
  options: GeometryOptions,
): Promise<BuiltGeometry | undefined> | undefined {
  return needsGeometry(scene) ? loadAndBuild(scene, options) : undefined;
}

/** The tree's builder is a tenth of what the renderer weighs: pages whose scenes have no need of it do not load it. */
async function loadAndBuild(scene: ResolvedScene, options: GeometryOptions): Promise<BuiltGeometry | undefined> {
  const [{ prepareGeometry }, { SceneGeometry }] = await Promise.all([
    import("../tree/geometry"),
    import("../gpu/sceneGeometry"),
  ]);
  const source = await prepareGeometry(scene, options);
  return source && { source, upload: (device) => new SceneGeometry(device, source) };
}
