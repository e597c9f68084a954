// Numbers and names of a glTF file, within what a scene allows.

import * as v from "valibot";

// The scene's numbers have to stay below 1e18 after a product of two.
const MAX_BRIGHTNESS = 1e8;
const MAX_UV_TRANSFORM = 1e6;

export const index = v.pipe(v.number(), v.integer(), v.minValue(0));
export const count = v.pipe(v.number(), v.integer(), v.minValue(1));
const between = (min: number, max: number) => v.pipe(v.number(), v.minValue(min), v.maxValue(max));
export const finite = between(-1e18, 1e18);
export const nonNegative = between(0, MAX_BRIGHTNESS);
export const name = v.optional(v.string());
export const vec2 = v.tuple([
  between(-MAX_UV_TRANSFORM, MAX_UV_TRANSFORM),
  between(-MAX_UV_TRANSFORM, MAX_UV_TRANSFORM),
]);
export const vec3 = v.tuple([finite, finite, finite]);
export const vec4 = v.tuple([finite, finite, finite, finite]);
export const color = v.tuple([nonNegative, nonNegative, nonNegative]);
export const isFlagged = v.optional(v.boolean());
