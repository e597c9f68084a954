// What a camera sees of meshes, in a picture of a few pixels that takes milliseconds.

import { add, cross, dot, length, normalize, scale, subtract } from "../math/vec3";
import type { Mesh } from "../scene/meshes";
import type { Camera, Vec3 } from "../scene/schema";

export type Uv = readonly [u: number, v: number];

/** A point of a mesh. */
type MeshPoint = {
  readonly point: Vec3;
  /** Of the triangle, unit. */
  readonly normal: Vec3;
  /** Texture coordinates of each of the two sets, if the mesh has it. */
  readonly uvs: readonly [Uv | undefined, Uv | undefined];
};

/** One on the side from which the camera sees it, which is that of its normal. */
export type SeenPoint = MeshPoint & { readonly mesh: Mesh; readonly isFront: boolean };

/** Pixels in a row and in a column. A part that covers a tenth of the picture is in 25 of them. */
const SIZE = 16;
/** Tests of a pixel against a triangle: a fraction of a second. Triangles beyond them are not looked at. */
const MAX_TESTS = 2 ** 25;

/** Lengths of the view from which rays are parallel enough for such pixels, while depths keep their digits. */
const FAR_AWAY = 1e6;

/** What is met, by pixel: arrays, because a mesh can have millions of triangles. */
type Sight = {
  readonly depths: Float64Array;
  /** Where the first index of the triangle is. */
  readonly triangles: Uint32Array;
  readonly meshes: (Mesh | undefined)[];
  /** Weights of the triangle's second and third corner. */
  readonly weights: Float64Array;
  /** Depth in front of which nothing is seen. */
  readonly start: number;
  tests: number;
};

/** The first thing that is met in the middle of each pixel of a square picture; pixels that meet nothing are not there. */
export function firstSight(camera: Camera, meshes: readonly Mesh[]): SeenPoint[] {
  const { target = [0, 0, 0], up = [0, 1, 0], verticalFov = 45, orthographicHeight: height } = camera;
  const toCamera = subtract(camera.position, target);
  const back = normalize(toCamera);
  // Parallel rays come from far away, and start at the camera.
  const start = height === undefined ? 0 : FAR_AWAY * (height + length(toCamera));
  const position = add(camera.position, scale(back, start));
  const slope = height === undefined ? Math.tan((verticalFov * Math.PI) / 360) : height / 2 / start;
  const right = normalize(cross(up, back));
  // Pixels are numbered by where x / −z and y / −z are between −1 and 1.
  const axes = [scale(right, 1 / slope), scale(cross(back, right), 1 / slope), back] as const;
  const sight: Sight = {
    depths: new Float64Array(SIZE * SIZE).fill(Number.POSITIVE_INFINITY),
    triangles: new Uint32Array(SIZE * SIZE),
    meshes: Array(SIZE * SIZE).fill(undefined),
    weights: new Float64Array(2 * SIZE * SIZE),
    tests: 0,
    start,
  };
  for (const mesh of meshes) look(mesh, toEyeSpace(mesh.positions as ArrayLike<number>, position, axes), sight);
  return sight.meshes.flatMap((mesh, pixel) => {
    if (mesh === undefined) return [];
    const [v, w] = [sight.weights[2 * pixel]!, sight.weights[2 * pixel + 1]!];
    return [toPoint(pointOf(mesh, sight.triangles[pixel]!, [1 - v - w, v, w]), mesh, position)];
  });
}

/** Positions relative to the camera, along its axes. */
function toEyeSpace(positions: ArrayLike<number>, origin: Vec3, axes: readonly [Vec3, Vec3, Vec3]): Float64Array {
  const eye = new Float64Array(positions.length);
  const [[rx, ry, rz], [ux, uy, uz], [bx, by, bz]] = axes;
  for (let i = 0; i < eye.length; i += 3) {
    const x = positions[i]! - origin[0];
    const y = positions[i + 1]! - origin[1];
    const z = positions[i + 2]! - origin[2];
    eye[i] = x * rx + y * ry + z * rz;
    eye[i + 1] = x * ux + y * uy + z * uz;
    eye[i + 2] = x * bx + y * by + z * bz;
  }
  return eye;
}

/** Looks at one mesh more. */
function look(mesh: Mesh, eye: Float64Array, sight: Sight): void {
  const indices = mesh.indices as ArrayLike<number>;
  for (let i = 0; i < indices.length && sight.tests < MAX_TESTS; i += 3) {
    const a = 3 * indices[i]!;
    const b = 3 * indices[i + 1]!;
    const c = 3 * indices[i + 2]!;
    const [az, bz, cz] = [eye[a + 2]!, eye[b + 2]!, eye[c + 2]!];
    if (az >= 0 && bz >= 0 && cz >= 0) continue;
    let [left, right, bottom, top] = [0, SIZE - 1, 0, SIZE - 1];
    // One that goes past the camera may be anywhere.
    if (az < 0 && bz < 0 && cz < 0) {
      const [ax, bx, cx] = [-eye[a]! / az, -eye[b]! / bz, -eye[c]! / cz];
      left = Math.max(left, Math.ceil(toPixel(Math.min(ax, bx, cx))));
      right = Math.min(right, Math.floor(toPixel(Math.max(ax, bx, cx))));
      if (left > right) continue;
      const [ay, by, cy] = [-eye[a + 1]! / az, -eye[b + 1]! / bz, -eye[c + 1]! / cz];
      bottom = Math.max(bottom, Math.ceil(toPixel(Math.min(ay, by, cy))));
      top = Math.min(top, Math.floor(toPixel(Math.max(ay, by, cy))));
      if (bottom > top) continue;
    }
    const [p, q, r] = [vectorAt(eye, a), vectorAt(eye, b), vectorAt(eye, c)];
    const [[ux, uy, uz], [vx, vy, vz], [wx, wy, wz]] = [cross(q, r), cross(r, p), cross(p, q)];
    const volume = p[0] * ux + p[1] * uy + p[2] * uz;
    sight.tests += (right - left + 1) * (top - bottom + 1);
    for (let row = bottom; row <= top; row++) {
      const y = (2 * row + 1) / SIZE - 1;
      for (let column = left; column <= right; column++) {
        const x = (2 * column + 1) / SIZE - 1;
        const u = x * ux + y * uy - uz;
        const v = x * vx + y * vy - vz;
        const w = x * wx + y * wy - wz;
        const isWithin = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
        const depth = volume / (u + v + w);
        const pixel = SIZE * row + column;
        if (!isWithin || !(depth > sight.start && depth < sight.depths[pixel]!)) continue;
        sight.depths[pixel] = depth;
        sight.meshes[pixel] = mesh;
        sight.triangles[pixel] = i;
        sight.weights[2 * pixel] = v / (u + v + w);
        sight.weights[2 * pixel + 1] = w / (u + v + w);
      }
    }
  }
}

/** Where a place between −1 and 1 is, in pixels from the middle of the first. */
function toPixel(place: number): number {
  return ((place + 1) * SIZE - 1) / 2;
}

function toPoint({ point, normal, uvs }: MeshPoint, mesh: Mesh, eye: Vec3): SeenPoint {
  const isFront = dot(normal, subtract(eye, point)) >= 0;
  return { mesh, point, normal: isFront ? normal : scale(normal, -1), isFront, uvs };
}

/**
 * A point of a mesh.
 *
 * @param triangle - where its first index is.
 * @param weights - of its corners; their sum is 1.
 */
export function pointOf(mesh: Mesh, triangle: number, weights: Vec3): MeshPoint {
  const { positions, indices, uvs, uvs1 } = mesh;
  const corners = [0, 1, 2].map((corner) => indices[triangle + corner]!);
  const [a, b, c] = corners.map((corner) => vectorAt(positions as ArrayLike<number>, 3 * corner)) as [Vec3, Vec3, Vec3];
  const point = add(add(scale(a, weights[0]), scale(b, weights[1])), scale(c, weights[2]));
  const uvOf = (set: Mesh["uvs"]): Uv | undefined => {
    if (set === undefined) return undefined;
    const along = (axis: number) => corners.reduce((sum, corner, i) => sum + weights[i]! * set[2 * corner + axis]!, 0);
    return [along(0), along(1)];
  };
  return {
    point,
    normal: normalize(cross(subtract(b, a), subtract(c, a))),
    uvs: [uvOf(uvs), uvOf(uvs1)],
  };
}

function vectorAt(values: ArrayLike<number>, at: number): Vec3 {
  return [values[at]!, values[at + 1]!, values[at + 2]!];
}
