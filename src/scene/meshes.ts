import type { SceneObject } from "./schema";

/** A mesh, as users write it. */
export type Mesh = Extract<SceneObject, { type: "mesh" }>;

export function meshesAmong(objects: readonly SceneObject[]): Mesh[] {
  return objects.filter((object) => object.type === "mesh");
}
