import type { FrameUniforms } from "../gpu/tracePass";
import { cameraBasis, emitterPixels, rayStart } from "./cameraBasis";
import type { InstalledScene } from "./installation";
import type { Slice } from "./schedule";
import type { Settings } from "./settings";

/** What the dispatches of one accumulation have in common. */
export type SharedUniforms = Omit<FrameUniforms, keyof Slice>;

/** On a film of this size, in pixels. */
export function sharedUniforms(
  { scene, camera, compiled }: InstalledScene,
  settings: Settings,
  width: number,
  height: number,
): SharedUniforms {
  const { seed, lightSamples, maxBounces = scene.maxBounces } = settings;
  const { origin, unit, shapes, emitters } = compiled;
  const basis = cameraBasis(camera, origin, width / height, unit);
  const start = rayStart(basis, shapes);
  return {
    ...start,
    ...emitterPixels(emitters, basis, width, height),
    size: [width, height],
    seed,
    maxBounces,
    lightSamples,
  };
}
