/** How radiance is brought into a display's range, in the order of `displayed` in `wgsl/tonemap.wgsl`. */
export const TONE_MAPS = ["none", "aces", "agx"] as const;

/** One of these ways: light cut off at 1, Hill's fit of ACES, or AgX. */
export type ToneMap = (typeof TONE_MAPS)[number];

/** How radiance becomes a picture. */
export type View = {
  /** In stops: each doubles the brightness. Default 0. */
  readonly exposure?: number;
  /**
   * `"aces"`, the default: Hill's fit of the ACES transforms. `"agx"`: Sobotka's AgX in Wrensch's fit, whose bright
   * colours turn white more gently. `"none"`: what is brighter than 1 is cut off. The papers are cited in `tonemap.wgsl`.
   */
  readonly toneMap?: ToneMap;
};
