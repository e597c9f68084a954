import type { Material, Rgb, TextureField } from "../../scene/schema";
import type { GltfTextureInfo } from "./materialSchema";

/** What a part of a glTF material is in the scene format. */
export type SurfacePart = {
  readonly fields: Material;
  /** Those that change the picture: the others are not loaded. */
  readonly textures: readonly (readonly [field: TextureField, texture: GltfTextureInfo | undefined])[];
};

/** Of an extension that has no effect. */
export const NOTHING: SurfacePart = { fields: {}, textures: [] };

// Far above what any of these is, and far below the 1e18 that a scene allows.
const MOST = 1e8;

/** The nearest number from 0 to 1. */
export function toFraction(value: number): number {
  return Math.min(1, Math.max(0, value));
}

/** Each component the nearest number from 0 to 1. */
export function toReflectance([r, g, b]: Rgb): Rgb {
  return [toFraction(r), toFraction(g), toFraction(b)];
}

/** The nearest number ≥ 0, of those that a scene allows. */
export function toPositive(value: number): number {
  return Math.min(MOST, Math.max(0, value));
}

/** Whether anything of a colour is more than 0. */
export function isBright(color: Rgb): boolean {
  return color.some((channel) => channel > 0);
}
