/** x, y, z. */
type Triple = readonly [number, number, number];

// Scene vectors stay in doubles, as plain triples, until the shader's f32 take them. wgpu-matrix, which the controls use,
// cannot be tree-shaken: for these lines it would be a seventh of what a page without controls downloads.

export const add = (a: Triple, b: Triple): Triple => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Triple, b: Triple): Triple => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Triple, factor: number): Triple => [a[0] * factor, a[1] * factor, a[2] * factor];
export const dot = (a: Triple, b: Triple): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Triple, b: Triple): Triple => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const length = (a: Triple): number => Math.hypot(...a);
export const normalize = (a: Triple): Triple => scale(a, 1 / length(a));
