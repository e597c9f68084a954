import type { Rgb, Vec3 } from "./schema";

/** How lengths change when a scene is measured in another unit. */
export type Measure = {
  readonly point: (p: Vec3) => Vec3;
  /** Of a length > 0. */
  readonly size: (x: number) => number;
  readonly coordinate: (x: number) => number;
  /** Of a power whose radiance stays. */
  readonly power: (watts: Rgb) => Rgb;
};
