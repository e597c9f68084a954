import { cross, dot, length, normalize, scale, subtract } from "../math/vec3";
import type { ResolvedLight, ResolvedMaterial, ResolvedObject, ResolvedScene, Rgb, Vec3 } from "../scene/schema";
import type { Geometry, MeshPart } from "./geometry";
import type { MeshLamp } from "./packLamps";

export type Axis = "X" | "Y" | "Z";

/** Geometry as the intersectors want it, relative to the compiled scene's origin. */
export type Shape =
  | {
      readonly kind: "sphere";
      readonly center: Vec3;
      readonly radius: number;
      /** Of a sphere that is huge against what is in view: its point nearest to the origin, exact where the centre is not. */
      readonly foot?: Vec3;
    }
  | { readonly kind: "plane"; readonly point: Vec3; readonly normal: Vec3; readonly axis: Axis | undefined }
  | {
      readonly kind: "quad";
      readonly corner: Vec3;
      readonly edge1: Vec3;
      readonly edge2: Vec3;
      readonly normal: Vec3;
      readonly axis: Axis | undefined;
    }
  | { readonly kind: "triangle"; readonly vertices: readonly [Vec3, Vec3, Vec3]; readonly normal: Vec3 }
  | {
      readonly kind: "box";
      readonly center: Vec3;
      readonly halfSize: Vec3;
      /** Angle about Y in radians; undefined when the box is axis-aligned. */
      readonly turn: number | undefined;
    }
  | {
      /** Its triangles are in the compiled scene's geometry. */
      readonly kind: "mesh";
      readonly lower: Vec3;
      readonly upper: Vec3;
      /** Of a mesh that emits and has an area. */
      readonly lamp: MeshLamp | undefined;
    };

/** Something a ray can hit. Its index in the scene is its id in the shader. */
export type Primitive = {
  readonly shape: Shape;
  /** `"black"`: the body of a sphere light, which reflects nothing. */
  readonly material: ResolvedMaterial | "black";
  /** Radiance, W·sr⁻¹·m⁻², from the front side. */
  readonly emission: Rgb;
};

/**
 * The scene's objects, then its sphere lights.
 *
 * @param geometry - of the scene's meshes.
 */
export function primitivesOf(scene: ResolvedScene, origin: Vec3, geometry?: Geometry): Primitive[] {
  const reach = reachOf(scene, origin);
  const parts = new Map(geometry?.parts.map((part) => [part.id, part]));
  const objects = scene.objects.map((object, id) => {
    const material = scene.materials[object.material]!;
    const lamp = geometry?.lamps.get(id);
    const shape = object.type === "mesh" ? meshShape(id, parts.get(id), lamp) : shapeOf(object, origin, reach);
    return { shape, material, emission: material.emission };
  });
  const lights = sphereLights(scene).map((light): Primitive => {
    const shape = sphereOf(subtract(light.position, origin), light.radius, reach);
    return { shape, material: "black", emission: sphereLightRadiance(light) };
  });
  return [...objects, ...lights];
}

/** The scene's shapes, meshes aside, each with the id of its primitive; one by one, for those who need no more than a few. */
export function* shapesOf(
  scene: ResolvedScene,
  origin: Vec3,
): Generator<{ readonly id: number; readonly shape: Shape }> {
  const reach = reachOf(scene, origin);
  for (const [id, object] of scene.objects.entries()) {
    if (object.type !== "mesh") yield { id, shape: shapeOf(object, origin, reach) };
  }
  for (const [i, { position, radius }] of sphereLights(scene).entries()) {
    yield { id: scene.objects.length + i, shape: sphereOf(subtract(position, origin), radius, reach) };
  }
}

/** Distance of the camera from the origin: the size of what is in view. */
function reachOf(scene: ResolvedScene, origin: Vec3): number {
  return length(subtract(scene.camera.position, origin));
}

function sphereLights({ lights }: ResolvedScene) {
  return lights.flatMap((light) => (light.type === "sphere" ? [light] : []));
}

/** Radiance of a diffuse sphere that gives `power` watts: power / (4π²·radius²), by area × π. */
function sphereLightRadiance(light: ResolvedLight & { type: "sphere" }): Rgb {
  return scale(light.power, 1 / (4 * Math.PI ** 2 * light.radius ** 2));
}

/** @param reach - see `reachOf`. */
function sphereOf(center: Vec3, radius: number, reach: number): Shape {
  const distance = length(center);
  const isHuge = radius > HUGE * Math.max(Math.abs(distance - radius), reach);
  return { kind: "sphere", center, radius, ...(isHuge && { foot: scale(center, 1 - radius / distance) }) };
}

// Coordinates relative to a sphere's centre lose digits against those relative to what is in view as soon as that is smaller:
// at 64 a horizon seen through a lens of 0.04° was 0.07 of a pixel too high. Nearer to 1 the other way loses a bit.
const HUGE = 1.5;

function meshShape(id: number, part: MeshPart | undefined, lamp: MeshLamp | undefined): Shape {
  if (!part) throw new TypeError(`objects[${id}]: the geometry of this mesh has not been prepared`);
  return { kind: "mesh", lower: part.lower, upper: part.upper, lamp };
}

function shapeOf(object: Exclude<ResolvedObject, { type: "mesh" }>, origin: Vec3, reach: number): Shape {
  switch (object.type) {
    case "sphere":
      return sphereOf(subtract(object.center, origin), object.radius, reach);
    case "plane": {
      const normal = normalize(object.normal);
      return { kind: "plane", point: subtract(object.point, origin), normal, axis: axisOf(normal) };
    }
    case "quad": {
      const { edge1, edge2 } = object;
      const normal = normalize(cross(edge1, edge2));
      const axis = axisOf(edge1) && axisOf(edge2) && axisOf(normal);
      return { kind: "quad", corner: subtract(object.corner, origin), edge1, edge2, normal, axis };
    }
    case "triangle": {
      const [a, b, c] = object.vertices;
      const normal = cross(subtract(b, a), subtract(c, a));
      const vertices = [subtract(a, origin), subtract(b, origin), subtract(c, origin)] as const;
      // A triangle without area is never hit, so any normal will do.
      return { kind: "triangle", vertices, normal: length(normal) > 0 ? normalize(normal) : [0, 1, 0] };
    }
    case "box": {
      const turn = object.rotationY % 180 === 0 ? undefined : (object.rotationY * Math.PI) / 180;
      return { kind: "box", center: subtract(object.center, origin), halfSize: scale(object.size, 0.5), turn };
    }
    default:
      return unreachable(object);
  }
}

/** Whether a triangle has an area, but for the rounding of its coordinates as written. */
export function hasArea([a, b, c]: readonly [Vec3, Vec3, Vec3]): boolean {
  const [edge1, edge2, edge3] = [subtract(b, a), subtract(c, a), subtract(c, b)];
  return length(cross(edge1, edge2)) > 1e-12 * Math.max(...[edge1, edge2, edge3].map((edge) => dot(edge, edge)));
}

function axisOf(direction: Vec3): Axis | undefined {
  const [x, y, z] = direction.map((component) => component !== 0);
  if (x && !y && !z) return "X";
  if (!x && y && !z) return "Y";
  if (!x && !y && z) return "Z";
  return undefined;
}

export function unreachable(value: never): never {
  throw new TypeError(`unexpected ${JSON.stringify(value)}`);
}
