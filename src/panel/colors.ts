import type { Rgb } from "../scene/schema";

// IEC 61966-2-1. Colour fields show sRGB, as people know it from elsewhere; scenes hold linear light.

/** A linear colour as `#rrggbb`; what is brighter than 1 is cut off. */
export function toHex(color: Rgb): string {
  const bytes = color.map((linear) => Math.round(255 * encode(Math.min(1, Math.max(0, linear)))));
  return `#${bytes.map((byte) => byte.toString(16).padStart(2, "0")).join("")}`;
}

/** The linear colour of `#rrggbb`. */
export function fromHex(hex: string): Rgb {
  const channel = (i: number) => decode(Number.parseInt(hex.slice(1 + 2 * i, 3 + 2 * i), 16) / 255);
  return [channel(0), channel(1), channel(2)];
}

/** How strong light is: its greatest component. */
export function strengthOf(light: Rgb): number {
  return Math.max(...light);
}

/** The colour of light, whatever its strength; that of no light is white. */
export function hueOf(light: Rgb): string {
  const strength = strengthOf(light);
  return strength > 0 ? toHex(times(light, 1 / strength)) : "#ffffff";
}

/** The same light at another strength; none takes its colour from `hex`. */
export function withStrength(light: Rgb, strength: number, hex: string): Rgb {
  const before = strengthOf(light);
  return before > 0 ? times(light, strength / before) : times(fromHex(hex), strength);
}

export function times([r, g, b]: Rgb, factor: number): Rgb {
  return [r * factor, g * factor, b * factor];
}

function encode(linear: number): number {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
}

function decode(encoded: number): number {
  return encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4;
}
