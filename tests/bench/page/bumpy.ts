import type { Scene } from "../../../src/scene/schema";
import { bumpySphere, placed } from "../../support/meshes";
import type { Measurement, MeasureOptions } from "../measurement";
import { measureOurs } from "../ours";

export type MeshRenderer = "ours" | "three-gpu-pathtracer";

/** Of one picture, and how many triangles its sphere really has. */
export type MeasuredMesh = { readonly triangles: number; readonly measurement: Measurement };

/**
 * Renders a bumpy sphere in a scene, 0.4 below the origin and in its material `white`.
 *
 * The sphere is made here: written as JSON, millions of triangles are more than can be handed to a page.
 *
 * @param triangles - about as many.
 */
export async function measureBumpy(
  renderer: MeshRenderer,
  scene: Scene,
  triangles: number,
  options: MeasureOptions,
): Promise<MeasuredMesh> {
  const sphere = placed(bumpySphere(triangles), 1, [0, -0.4, 0]);
  const positions = Float64Array.from(sphere.positions);
  const indices = Uint32Array.from(sphere.indices);
  const whole: Scene = {
    ...scene,
    objects: [...scene.objects, { type: "mesh", positions, indices, material: "white" }],
  };
  return { triangles: indices.length / 3, measurement: await render(renderer, whole, options) };
}

async function render(renderer: MeshRenderer, scene: Scene, options: MeasureOptions): Promise<Measurement> {
  if (renderer === "ours") return measureOurs("ours", scene, options);
  const { measure } = await import("../rivals/threeGpuPathTracer/measure");
  return measure(scene, options);
}
