import { vec3d } from "wgpu-matrix";
import type { Vec3 } from "../scene/schema";

// Scene vectors stay in doubles, as plain triples, until the shader's f32 take them.

export const add = (a: Vec3, b: Vec3): Vec3 => triple(vec3d.add(a, b));
export const subtract = (a: Vec3, b: Vec3): Vec3 => triple(vec3d.subtract(a, b));
export const scale = (a: Vec3, factor: number): Vec3 => triple(vec3d.scale(a, factor));
export const cross = (a: Vec3, b: Vec3): Vec3 => triple(vec3d.cross(a, b));
export const length = (a: Vec3): number => Math.hypot(...a);
export const normalize = (a: Vec3): Vec3 => scale(a, 1 / length(a));

function triple(v: ArrayLike<number>): Vec3 {
  return [v[0]!, v[1]!, v[2]!];
}
