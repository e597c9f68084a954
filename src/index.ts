export { LoadError, RtViewerError, SceneError, type SceneIssue, UnsupportedError, WebGpuError } from "./errors";
export type { ToneMap } from "./gpu/blitPass";
export type { View } from "./renderer/display";
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
  Vec3,
} from "./scene/schema";
