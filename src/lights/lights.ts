// Every kind of light, a line each.

import type { ResolvedLight, ResolvedObject, Rgb, Vec3 } from "../scene/schema";
import type { Light, SceneLight } from "./light";
import { point } from "./point";
import { sphere } from "./sphere";

const SCENE_LIGHTS = { point, sphere } as const satisfies {
  readonly [K in ResolvedLight["type"]]: SceneLight<ResolvedLight & { type: K }>;
};

/** Everything there is to know of a light's kind. TypeScript does not correlate a union with its table. */
export function kindOfLight({ type }: ResolvedLight): SceneLight<ResolvedLight> {
  return SCENE_LIGHTS[type] as unknown as SceneLight<ResolvedLight>;
}

/** See `SceneLight`. */
export function bodyOf(light: ResolvedLight): { readonly body: ResolvedObject; readonly radiance: Rgb } | undefined {
  return kindOfLight(light).body?.(light);
}

/** See `SceneLight`. */
export function lightsOf(light: ResolvedLight, origin: Vec3): Light[] {
  return kindOfLight(light).lights?.(light, origin) ?? [];
}

/** Ways to sample a light, by their number in `wgsl/lights.wgsl`. */
export const LIGHT_KINDS = { sphere: 0, quad: 1, triangle: 2, point: 3, mesh: 4 } as const;

/** Of a kind of light in the shader. */
export function numberOfLight(kind: string): number {
  return LIGHT_KINDS[kind as keyof typeof LIGHT_KINDS];
}
