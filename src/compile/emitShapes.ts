// @lean wgsl
// Writes the part of the shader module `scene` that finds what a ray meets.

import type { Light } from "../lights/light";
import type { EmittedShape } from "../shapes/shape";
import { ITEMS, itemTag, kindOf, kindOfObject, type Shape } from "../shapes/shapes";
import type { Geometry } from "../tree/geometry";
import { emitBlockingLoops, emitClosestLoops } from "./emitLoops";
import { familyOf, hasHolesAt } from "./features";
import type { Primitive } from "./primitives";
import type { Unrolling } from "./unrolling";
import type { Values } from "./values";

/**
 * `closestHit`, `occluded`, and what the shader has to ask of single kinds of shapes: `shapeNormal` and, for the tree,
 * `itemIntersect` and `itemNormal`.
 *
 * @param blocks - whether primitive `id` can come between a shaded point and a light.
 */
export function emitShapes(
  primitives: readonly Primitive[],
  lights: readonly Light[],
  unrolling: Unrolling,
  geometry: Geometry | undefined,
  values: Values,
  blocks: (id: number) => boolean,
): string {
  const sampled = new Set(lights.map((light) => light.primitive));
  const emitted = unrolling.unrolled.map((id) => ({ id, ...emitShape(primitives[id]!.shape, id, values) }));
  const isSheared = emitted.some(({ distance }) => distance.includes("(shear,"));
  const shear = isSheared ? "  let shear = shearOf(ray);\n" : "";
  const isPart = (id: number) => hasHolesAt(primitives, id);
  const part = (id: number) => (isPart(id) ? "Part" : "");
  // What has passed the near side of a closed shape may meet the far one.
  const farSide = (id: number, distance: string, meet: string) => {
    if (!isPart(id) || familyOf(primitives[id]!.shape) === "flat") return "";
    return `  if (entersPart(ray, ${distance}, ${id}u)) { let outer = ray; let ray = innerRay(outer, ${id}u); ${meet} }\n`;
  };
  const closest = emitted.map(({ id, distance }) => {
    const meet = (ray: string) => `hit = nearer${part(id)}(hit, ${distance}, ${id}u, ${ray});`;
    return `  ${meet("ray")}\n${farSide(id, distance, meet("outer"))}`;
  });
  const blockers = emitted.map(({ id, distance }) => {
    const isTarget = sampled.has(id);
    if (isTarget && lights.length === 1) return ""; // a light never hides itself
    // What can't come between two points of the scene may be passed on the way out of it.
    if (!blocks(id) && !isPart(id)) return "";
    const other = isTarget ? ` & (target_ != ${id}u)` : "";
    const block = (ray: string) => `blocked |= between${part(id)}(${distance}, distance, ${id}u, ${ray})${other};`;
    return `  ${block("ray")}\n${farSide(id, distance, block("outer"))}`;
  });
  const normals = emitted.map(({ id, normal }) => (normal ? `  n = select(n, ${normal}, id == ${id}u);\n` : ""));
  return `
fn closestHit(ray: Ray) -> Hit {
${shear}  var hit = noHit();
${closest.join("")}${emitClosestLoops(unrolling, isPart)}${geometry ? "  hit = treeClosest(ray, hit);\n" : ""}  return hit;
}

// Whether something other than \`target_\` lies between the ray's origin and the point at \`distance\`.
fn occluded(ray: Ray, distance: f32, target_: u32) -> bool {
${shear}  var blocked = false;
${blockers.join("")}${emitBlockingLoops(unrolling, isPart)}${geometry ? "  if (!blocked) { blocked = treeOccludes(ray, distance, target_); }\n" : ""}  return blocked;
}

// Outward normals of solids.
fn shapeNormal(ray: Ray, id: u32, p: vec3f, otherwise: vec3f) -> vec3f {
  var n = otherwise;
${normals.join("")}  return n;
}
${geometry ? emitItems(geometry) : ""}`;
}

function emitShape(shape: Shape, id: number, values: Values): EmittedShape {
  const { emit } = kindOf(shape);
  if (!emit) throw new TypeError(`a ${shape.kind} is never unrolled`);
  return emit(shape, id, values);
}

/** The numbers of the kinds of shapes in a tree. */
function itemTags({ treeShapes }: Geometry): ReadonlySet<number> {
  return new Set(treeShapes.map(({ shape }) => itemTag(shape)));
}

function emitItems(geometry: Geometry): string {
  const tags = itemTags(geometry);
  const items = ITEMS.filter(({ tag }) => tags.has(tag));
  const ofMesh = geometry.parts[0] && kindOfObject(geometry.parts[0].object).triangleDistance;
  const first = ofMesh ?? items[0]!.distance;
  const others = items.filter(({ distance }) => distance !== first);
  const distances = others.map(({ tag, distance }) => `  t = select(t, ${distance}, item.kind == ${tag}u);\n`);
  const normals = items.map(({ tag, normal }) => (normal ? `  if (item.kind == ${tag}u) { return ${normal}; }\n` : ""));
  return `
// Distance to an item that a ray would name \`id\`, not positive for a miss.
fn itemIntersect(ray: Ray, shear: Shear, slot: u32, id: u32) -> f32 {
  let item = itemAt(slot);
  var t = ${first};
${distances.join("")}  return t;
}

fn itemNormal(ray: Ray, id: u32, item: Item, p: vec3f, otherwise: vec3f) -> vec3f {
${normals.join("")}  return otherwise;
}
`;
}
