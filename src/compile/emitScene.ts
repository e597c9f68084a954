// Writes the shader module `scene`: the scene's own intersection functions, unrolled, and access to its tables.
// Numbers come from validated scenes only and names from this file; no user text reaches WGSL.

import type { Vec3 } from "../scene/schema";
import type { Emitter } from "./emitters";
import type { Features } from "./features";
import { type Primitive, type Shape, unreachable } from "./primitives";
import type { Values } from "./values";
import { add, cross, length, scale } from "./vec3";

/** The text of module `scene`, given how numbers are named and how many slots the uniform holds in the end. */
export function emitScene(
  primitives: readonly Primitive[],
  emitters: readonly Emitter[],
  features: Features,
  values: Values,
  slotCount: () => number,
): string {
  const sampled = new Set(emitters.map((emitter) => emitter.primitive));
  const emitted = primitives.map(({ shape }, id) => emitPrimitive(shape, id, values));
  const shear = features.TRIANGLES ? "  let shear = shearOf(ray);\n" : "";

  const closest = emitted.map(({ distance }, id) => `  hit = nearer(hit, ${distance}, ${id}u, ray);\n`).join("");
  const blockers = emitted
    .map(({ distance }, id) => {
      const isTarget = sampled.has(id);
      if (isTarget && emitters.length === 1) return ""; // a light never hides itself
      const other = isTarget ? ` & (target_ != ${id}u)` : "";
      return `  blocked |= between(${distance}, distance, ${id}u, ray)${other};\n`;
    })
    .join("");
  const normals = emitted
    .map(({ normal }, id) => (normal ? `  n = select(n, ${normal}, id == ${id}u);\n` : ""))
    .join("");

  return `
import package::box::{boxIntersect, boxNormal, turnedBoxIntersect};
import package::lights::Light;
import package::planar::{planeIntersect, planeIntersectX, planeIntersectY, planeIntersectZ, quadIntersect,
  quadIntersectX, quadIntersectY, quadIntersectZ, shearOf, triangleIntersect};
import package::ray::{Hit, Ray, between, nearer, noHit};
import package::sphere::sphereIntersect;
import package::surface::Material;

struct Scene {
  environment: vec4f,
  materials: array<Material, ${Math.max(primitives.length, 1)}>,
  // Centre and radius of a sphere; unit normal and 0 of a flat primitive; a box has only w, -1.
  shapes: array<vec4f, ${Math.max(primitives.length, 1)}>,
  lights: array<Light, ${Math.max(emitters.length, 1)}>,
  // Values of the intersection functions below.
  slots: array<vec4f, ${Math.max(slotCount(), 1)}>,
}

// Written by the renderer when the scene changes.
@group(0) @binding(1) var<uniform> scene: Scene;

fn closestHit(ray: Ray) -> Hit {
${shear}  var hit = noHit();
${closest}  return hit;
}

// Whether something other than \`target_\` lies between the ray's origin and the point at \`distance\`.
fn occluded(ray: Ray, distance: f32, target_: u32) -> bool {
${shear}  var blocked = false;
${blockers}  return blocked;
}

// Outward normals of shapes whose normal is neither constant nor radial.
fn shapeNormal(id: u32, p: vec3f, otherwise: vec3f) -> vec3f {
  var n = otherwise;
${normals}  return n;
}

fn environment() -> vec3f {
  return scene.environment.rgb;
}

fn lightAt(index: u32) -> Light {
  return scene.lights[index];
}

struct LightChoice {
  index: u32,
  // The point, stretched back over [0, 1)².
  u: vec2f,
}

fn chooseLight(u: vec2f) -> LightChoice {
${emitChoice(emitters)}}
`;
}

type EmittedPrimitive = {
  /** A WGSL expression for the distance at which `ray` meets the primitive; not positive for a miss. */
  readonly distance: string;
  /** One for the outward normal at `p`, where it is neither constant nor radial. */
  readonly normal?: string;
};

function emitPrimitive(shape: Shape, id: number, values: Values): EmittedPrimitive {
  switch (shape.kind) {
    case "sphere":
      return { distance: `sphereIntersect(ray, ${values.vec3(shape.center)}, ${values.scalar(shape.radius)}, ${id}u)` };
    case "plane": {
      const { point, normal, axis } = shape;
      if (axis) return { distance: `planeIntersect${axis}(ray, ${values.scalar(point["XYZ".indexOf(axis)]!)})` };
      return { distance: `planeIntersect(ray, ${values.vec3(point)}, ${values.vec3(normal)})` };
    }
    case "quad": {
      const { corner, edge1, edge2, normal, axis } = shape;
      const halfDiagonal = scale(add(edge1, edge2), 0.5);
      const center = values.vec3(add(corner, halfDiagonal));
      if (axis) return { distance: `quadIntersect${axis}(ray, ${center}, ${values.vec3(absolute(halfDiagonal))})` };
      const [dual1, dual2] = halfEdgeDuals(edge1, edge2, normal);
      return {
        distance: `quadIntersect(ray, ${center}, ${values.vec3(normal)}, ${values.vec3(dual1)}, ${values.vec3(dual2)})`,
      };
    }
    case "triangle": {
      const vertices = shape.vertices.map((vertex) => values.vec3(vertex)).join(", ");
      return { distance: `triangleIntersect(shear, ${vertices})` };
    }
    case "box": {
      const { center, halfSize, turn = 0 } = shape;
      const body = `${values.vec3(center)}, ${values.vec3(halfSize)}`;
      const rotation = `vec2f(${values.scalar(Math.cos(turn))}, ${values.scalar(Math.sin(turn))})`;
      const normal = `boxNormal(p, ${body}, ${rotation})`;
      if (shape.turn === undefined) return { distance: `boxIntersect(ray, ${body}, ${id}u)`, normal };
      return { distance: `turnedBoxIntersect(ray, ${body}, ${rotation}, ${id}u)`, normal };
    }
    default:
      return unreachable(shape);
  }
}

/** Vectors d1, d2 in the plane of the edges with d·(half edge) = 1 for their own and 0 for the other. */
function halfEdgeDuals(edge1: Vec3, edge2: Vec3, normal: Vec3): [Vec3, Vec3] {
  const area = length(cross(edge1, edge2));
  return [scale(cross(edge2, normal), 2 / area), scale(cross(normal, edge1), 2 / area)];
}

function absolute([x, y, z]: Vec3): Vec3 {
  return [Math.abs(x), Math.abs(y), Math.abs(z)];
}

function emitChoice(emitters: readonly Emitter[]): string {
  if (emitters.length <= 1) return "  return LightChoice(0u, u);\n";
  const steps = emitters.map((_, i) =>
    i === 0 ? "" : `  index = select(index, ${i}u, u.x >= scene.lights[${i}].start);\n`,
  );
  return `  var index = 0u;
${steps.join("")}  let light = scene.lights[index];
  let x = (u.x - light.start) / light.probability;
  return LightChoice(index, vec2f(clamp(x, 0.0, 0x1.fffffep-1), u.y));
`;
}
