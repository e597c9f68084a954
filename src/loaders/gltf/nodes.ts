// Where things stand: the node hierarchy as world matrices.

import { mat4d, quatd } from "wgpu-matrix";
import { LoadError } from "../../errors";
import type { Vec3 } from "../../scene/schema";
import { MAX_DISTANCE } from "../limits";
import type { GltfJson } from "./schema";

type GltfNode = GltfJson["nodes"][number];

/** A node and its matrix: 16 doubles by columns, from its space to the world's. */
export type PlacedNode = { readonly index: number; readonly node: GltfNode; readonly world: Float64Array };

/**
 * Every node of the scene that the file shows, parents before children. Without any scene, every root is shown.
 *
 * @throws {LoadError} if a matrix gets too large to reckon with.
 */
export function placeNodes(json: GltfJson): PlacedNode[] {
  const placed: PlacedNode[] = [];
  const waiting = rootsOf(json)
    .map((index) => ({ index, parent: mat4d.identity() }))
    .reverse();
  for (let next = waiting.pop(); next !== undefined; next = waiting.pop()) {
    const node = json.nodes[next.index]!;
    const world = checkReach(mat4d.multiply(next.parent, localMatrix(node)), `nodes[${next.index}]`);
    placed.push({ index: next.index, node, world });
    for (const child of [...(node.children ?? [])].reverse()) waiting.push({ index: child, parent: world });
  }
  return placed;
}

/** @throws {LoadError} if a matrix gets too large to reckon with. */
export function checkReach(matrix: Float64Array, path: string): Float64Array {
  if (matrix.every((value) => Math.abs(value) <= MAX_DISTANCE)) return matrix;
  throw new LoadError(`${path}: its place or scale in the world is larger than ${MAX_DISTANCE}`);
}

function rootsOf({ scenes, scene = 0, nodes }: GltfJson): readonly number[] {
  if (scenes.length > 0) return scenes[scene]!.nodes;
  const children = new Set(nodes.flatMap((node) => node.children ?? []));
  return [...nodes.keys()].filter((index) => !children.has(index));
}

function localMatrix({ matrix, translation = [0, 0, 0], rotation = [0, 0, 0, 1], scale = [1, 1, 1] }: GltfNode) {
  return matrix === undefined ? compose(translation, rotation, scale) : Float64Array.from(matrix);
}

/** Scales, then rotates by a quaternion of any length, then moves. */
export function compose(translation: ArrayLike<number>, rotation: ArrayLike<number>, scale: ArrayLike<number>) {
  const matrix = mat4d.fromQuat(quatd.normalize([rotation[0]!, rotation[1]!, rotation[2]!, rotation[3]!]));
  mat4d.scale(matrix, [scale[0]!, scale[1]!, scale[2]!], matrix);
  mat4d.setTranslation(matrix, [translation[0]!, translation[1]!, translation[2]!], matrix);
  return matrix;
}

/** Where the origin of a space is in the world. */
export function positionOf(world: Float64Array): Vec3 {
  return [world[12]!, world[13]!, world[14]!];
}

/** An axis of a space, 0 for x, in the world; as long as a unit there is here. */
export function axisOf(world: Float64Array, axis: 0 | 1 | 2): Vec3 {
  return [world[4 * axis]!, world[4 * axis + 1]!, world[4 * axis + 2]!];
}
