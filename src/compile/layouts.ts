import { defineStruct } from "./defineStruct";

/** One light: `Light` in `lights/light.wgsl`. */
export const LIGHT = defineStruct({
  position: "vec3f",
  size: "f32",
  edge1: "vec3f",
  kind: "u32",
  edge2: "vec3f",
  id: "u32",
  radiance: "vec3f",
  normal: "vec3f",
});

/** A plane or a huge sphere that is not unrolled: `Unbounded` in the generated module; see `emitLoops.ts`. */
export const UNBOUNDED = defineStruct({
  point: "vec3f",
  id: "u32",
  direction: "vec3f",
});

const LOOK = { place: "vec3u", wrapU: "u32", wrapV: "u32", nearest: "u32" } as const;
/** One texture: `Texture` in `wgsl/textures.wgsl`. */
export const TEXTURE = defineStruct(LOOK);
/** The same with `UV_TRANSFORMS`: one texture in one of its places. */
export const PLACED_TEXTURE = defineStruct({ ...LOOK, uv: "u32", toU: "vec3f", toV: "vec3f" });

/** What changes from dispatch to dispatch: `FrameUniforms` in `wgsl/frameUniforms.wgsl`. */
export const FRAME = defineStruct({
  origin: "vec3f",
  sampleCount: "u32",
  forward: "vec3f",
  firstSample: "u32",
  right: "vec3f",
  half: "u32",
  up: "vec3f",
  seed: "u32",
  size: "vec2u",
  firstStrip: "u32",
  endStrip: "u32",
  unitStrips: "u32",
  unitStride: "u32",
  maxBounces: "u32",
  lightSamples: "u32",
  near: "f32",
  emittersFrom: "vec2u",
  emittersTo: "vec2u",
  lens: "vec2f",
});

/** How the film is shown: `View` in `wgsl/blit.wgsl`. */
export const VIEW = defineStruct({
  filmSize: "vec2u",
  targetSize: "vec2u",
  exposure: "f32",
  toneMap: "u32",
});
