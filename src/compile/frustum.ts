import type { Vec3 } from "../scene/schema";

/** What a camera sees: the ray through image plane coordinates (x, y) in [-1, 1] runs along forward + x·right + y·up, forward unit. */
export type Frustum = { readonly origin: Vec3; readonly forward: Vec3; readonly right: Vec3; readonly up: Vec3 };
