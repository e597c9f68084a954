// Which shapes go into the tree of a scene that has too many to unroll them all.

import type { ResolvedScene } from "../scene/schema";
import { ITEMS } from "../shapes/shapes";
import { type BoundedPrimitive, boundedShapesOf, isWall, MAX_UNROLLED } from "./boundedShapes";
import { boundsOfShape } from "./boundsOfShape";

// A shape whose box has this share of the surface of the box around all is met by so many rays that the tree is a detour: a
// sample of a room of 42 balls took 425 ms of a software adapter with its walls in the tree, and 264 ms without.
const LARGE_SHARE = 1 / 10;
// Kinds of so few shapes are not worth the test that every item of the tree would need: with its one lamp unrolled, the room
// took 234 ms.
const FEW = 4;
// As many large shapes as few ones of all kinds leave room for.
const MOST_LARGE = MAX_UNROLLED - ITEMS.length * FEW;

/**
 * The bounded shapes that are not unrolled: walls that light passes straight; of the others none of up to `MAX_UNROLLED`, and of more
 * all but the large ones and rare kinds.
 */
export function treeShapesOf(scene: ResolvedScene): BoundedPrimitive[] {
  const all = boundedShapesOf(scene);
  const walls = all.filter((each) => isWall(scene, each));
  const others = all.filter((each) => !isWall(scene, each));
  return [...walls, ...small(others)].sort((a, b) => a.id - b.id);
}

function small(bounded: readonly BoundedPrimitive[]): BoundedPrimitive[] {
  if (bounded.length <= MAX_UNROLLED) return [];
  const boxes = bounded.map(({ shape }) => boundsOfShape(shape));
  const least = LARGE_SHARE * halfArea(boxAround(boxes));
  const larger = boxes.flatMap((box, i) => (halfArea(box) > least ? [{ i, area: halfArea(box) }] : []));
  const largestFirst = larger.sort((a, b) => b.area - a.area);
  const large = new Set(largestFirst.slice(0, MOST_LARGE).map(({ i }) => i));
  const rest = bounded.filter((_, i) => !large.has(i));
  const counts = new Map<string, number>();
  for (const { shape } of rest) counts.set(shape.kind, (counts.get(shape.kind) ?? 0) + 1);
  return rest.filter(({ shape }) => counts.get(shape.kind)! > FEW);
}

type Box = readonly number[];

function boxAround(boxes: readonly Box[]): Box {
  const around = [...boxes[0]!];
  for (const box of boxes) {
    for (let i = 0; i < 6; i++) around[i] = i < 3 ? Math.min(around[i]!, box[i]!) : Math.max(around[i]!, box[i]!);
  }
  return around;
}

function halfArea(box: Box): number {
  const [x, y, z] = [box[3]! - box[0]!, box[4]! - box[1]!, box[5]! - box[2]!] as const;
  return x * y + y * z + z * x;
}
