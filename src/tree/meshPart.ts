import type { Vec3 } from "../scene/schema";
import type { MeshObject } from "../shapes/shapes";

/** A mesh among the scene's objects, relative to the geometry's origin. */
export type MeshPart = {
  readonly object: MeshObject;
  /** Its place in `scene.objects`, which is its primitive's id. */
  readonly id: number;
  /** x, y, z per vertex, as the shader has them. */
  readonly positions: Float32Array;
  /** Number of its first triangle among those of all meshes. */
  readonly firstTriangle: number;
  /** What holds it. */
  readonly lower: Vec3;
  readonly upper: Vec3;
};
