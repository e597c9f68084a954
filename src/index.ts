export { LoadError, RtViewerError, SceneError, type SceneIssue, UnsupportedError, WebGpuError } from "./errors";
export type { ToneMap, View } from "./renderer/view";

// docs/api lists exports in this order. Biome sorts up to a comment, so that the view stays before the tracer.

export { PathTracer, type PathTracerOptions, type SceneOptions } from "./renderer/pathTracer";
export type { Picked } from "./renderer/picker";
export { DEFAULT_SETTINGS, type Settings } from "./renderer/settings";
export type { Stats } from "./renderer/stats";
export * from "./scene/builders";
export { conductorF0, dielectricF0, metals } from "./scene/metals";
export { parseScene } from "./scene/parseScene";
export type {
  Camera,
  Environment,
  Light,
  Material,
  ResolvedCamera,
  ResolvedScene,
  Rgb,
  Scene,
  SceneObject,
  Texture,
  TextureReference,
  Vec3,
} from "./scene/schema";
