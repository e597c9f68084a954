import type { CompiledScene } from "../compile/compileScene";
import type { Geometry } from "../tree/geometry";

// Rays that the slowest adapter, a processor of two cores, traces in some 50 ms where a scene is one room of a few shapes.
const FIRST_RAYS = 150_000;
// More paths tell no more about an adapter.
const MOST_FIRST_PATHS = 8192;
// How many times as long as there a ray takes in a tree of any size, on that adapter.
const TREE_COST = 7;
// Of what is looked through one by one, a light or a plane, so many cost as much as that room.
const LISTED_PER_RAY = 64;

/**
 * Camera paths that no adapter takes long for, whatever the scene: as if each scattered as often as it may, with all its light
 * samples. Before anything has been measured, no more is dared.
 */
export function firstPathsFor(
  { lightCount, shapes }: Pick<CompiledScene, "lightCount" | "shapes">,
  tree: Pick<Geometry, "shapes"> | undefined,
  maxBounces: number,
  lightSamples: number,
): number {
  const rays = (maxBounces + 1) * (lightSamples + 1);
  const listed = lightCount + shapes.length - (tree?.shapes.size ?? 0);
  const cost = 1 + listed / LISTED_PER_RAY + (tree ? TREE_COST : 0);
  return Math.max(1, Math.min(MOST_FIRST_PATHS, Math.floor(FIRST_RAYS / (rays * cost))));
}
