// Where things stand: the node hierarchy as world matrices.

import { mat4d, quatd } from "wgpu-matrix";
import { LoadError } from "../../errors";
import type { Vec3 } from "../../scene/schema";
import { MAX_DISTANCE } from "../limits";
import type { Warnings } from "../warnings";
import { placeOf } from "./materials";
import type { GltfJson } from "./schema";

type GltfNode = GltfJson["nodes"][number];

/** A node in its place. */
export type PlacedNode = {
  readonly index: number;
  readonly node: GltfNode;
  /** 16 doubles by columns, from its space to the world's. */
  readonly world: Float64Array;
  /** Whether its mesh and its light are shown: neither it nor an ancestor says otherwise, by `KHR_node_visibility`. */
  readonly isVisible: boolean;
};

/**
 * Every node of the scene that the file shows, parents before children. Without any scene, all nodes.
 *
 * A node is placed once: as a root if the scene lists it, else under the first parent that is met. This also cuts rings.
 *
 * @throws {LoadError} if a matrix gets too large to reckon with.
 */
export function placeNodes(json: GltfJson, warnings: Warnings): PlacedNode[] {
  const { nodes, scenes } = json;
  const placed: PlacedNode[] = [];
  const roots = scenes.length > 0 ? listedRoots(json, warnings) : parentlessNodes(nodes);
  const known = new Set(roots);
  const placeBelow = (tops: Iterable<number>) => {
    const waiting = [...tops].reverse().map((index) => ({ index, parent: mat4d.identity(), isShown: true }));
    for (let next = waiting.pop(); next !== undefined; next = waiting.pop()) {
      const { index, parent, isShown } = next;
      const node = nodes[index]!;
      const world = checkReach(mat4d.multiply(parent, localMatrix(node)), `nodes[${index}]`);
      const isVisible = isShown && node.extensions?.KHR_node_visibility?.visible !== false;
      placed.push({ index, node, world, isVisible });
      const children = (node.children ?? []).filter((child) => {
        const isNew = !known.has(child);
        if (!isNew && !roots.has(child)) {
          const place = placeOf("nodes", child, nodes[child]!.name);
          warnings.add("A node has two parents, or is below itself: it is shown in one place only", place);
        }
        known.add(child);
        return isNew;
      });
      for (const child of children.reverse()) waiting.push({ index: child, parent: world, isShown: isVisible });
    }
  };
  placeBelow(roots);
  // Without a scene, a ring of nodes has no root.
  if (scenes.length === 0) {
    for (const index of nodes.keys()) {
      if (known.has(index)) continue;
      known.add(index);
      placeBelow([index]);
    }
  }
  return placed;
}

/** The nodes that the scene lists, even those that are children of others. */
function listedRoots({ scenes, scene = 0, nodes }: GltfJson, warnings: Warnings): ReadonlySet<number> {
  const children = childrenOf(nodes);
  const roots = new Set<number>();
  for (const index of scenes[scene]!.nodes) {
    const place = placeOf("nodes", index, nodes[index]!.name);
    if (roots.has(index)) warnings.add("The scene lists a node twice: it is shown once", place);
    else if (children.has(index)) {
      warnings.add("The scene lists a node that is another's child: it is shown as a root, without its parent", place);
    }
    roots.add(index);
  }
  return roots;
}

function parentlessNodes(nodes: readonly GltfNode[]): ReadonlySet<number> {
  const children = childrenOf(nodes);
  return new Set([...nodes.keys()].filter((index) => !children.has(index)));
}

function childrenOf(nodes: readonly GltfNode[]): ReadonlySet<number> {
  return new Set(nodes.flatMap(({ children = [] }) => children));
}

/** Whether a matrix has numbers to reckon with. */
export function isWithinReach(matrix: Float64Array): boolean {
  return matrix.every((value) => Math.abs(value) <= MAX_DISTANCE);
}

/** @throws {LoadError} if a matrix gets too large to reckon with. */
function checkReach(matrix: Float64Array, path: string): Float64Array {
  if (isWithinReach(matrix)) return matrix;
  throw new LoadError(`${path}: its place or scale in the world is larger than ${MAX_DISTANCE}`);
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
