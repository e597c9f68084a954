import type { ResolvedScene } from "./schema";

/** One of a scene's objects or lights, by its index there. */
export type ScenePart = { readonly kind: "object" | "light"; readonly index: number };

/** What the primitive of an id belongs to: ids count the scene's objects, then its sphere lights. */
export function partOf({ objects, lights }: ResolvedScene, id: number): ScenePart {
  if (id < objects.length) return { kind: "object", index: id };
  const spheres = [...lights.keys()].filter((index) => lights[index]!.type === "sphere");
  return { kind: "light", index: spheres[id - objects.length]! };
}
