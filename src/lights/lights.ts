// Every kind of light, a line each. To add one: its entry in the scene's schema, its file and shader module here, and a line below.

import type { ResolvedLight, ResolvedObject, Rgb, Vec3 } from "../scene/schema";
import { quad, triangle } from "./area";
import { directional } from "./directional";
import type { Light, LightKind, LightSampler, SceneLight } from "./light";
import { mesh } from "./mesh";
import { point } from "./point";
import { sphere } from "./sphere";
import { spot } from "./spot";

type InScenes = { readonly [K in ResolvedLight["type"]]: SceneLight<ResolvedLight & { type: K }> };

/** In the order in which the shader numbers them. */
export const LIGHT_KINDS = { sphere, quad, triangle, point, mesh, directional, spot } as const satisfies InScenes &
  Readonly<Record<string, LightKind>>;

/** Everything there is to know of a light's kind. TypeScript does not correlate a union with its table. */
export function kindOfLight({ type }: ResolvedLight): SceneLight<ResolvedLight> {
  return LIGHT_KINDS[type] as unknown as SceneLight<ResolvedLight>;
}

/** See `SceneLight`. */
export function bodyOf(light: ResolvedLight): { readonly body: ResolvedObject; readonly radiance: Rgb } | undefined {
  return kindOfLight(light).body?.(light);
}

/** See `SceneLight`. */
export function lightsOf(light: ResolvedLight, origin: Vec3): Light[] {
  return kindOfLight(light).lights?.(light, origin) ?? [];
}

const NAMES: readonly string[] = Object.keys(LIGHT_KINDS);

/** The number of a light's kind in the shader. */
export function tagOf({ kind }: Light): number {
  return NAMES.indexOf(kind);
}

/** A light and the same from its other side, where its kind has one. */
export function bothSides(light: Light): Light[] {
  const front = { ...light, front: undefined };
  const back = kindNamed(light.kind).turn?.(front);
  return back ? [front, back] : [front];
}

/** See `LightKind`. */
export function isDistant({ kind }: Light): boolean {
  return kindNamed(kind).isDistant ?? false;
}

/** How a light is sampled. */
export function samplerOf({ kind }: Light): LightSampler {
  return kindNamed(kind).sampler;
}

function kindNamed(kind: string): LightKind {
  const name = NAMES.find((each) => each === kind) as keyof typeof LIGHT_KINDS | undefined;
  if (!name) throw new TypeError(`no light is sampled as a ${kind}`);
  return LIGHT_KINDS[name];
}
