// How the film is cut up, as `wgsl/slice.wgsl` has it.

/** The side of a block, which a workgroup traces, in pixels. */
export const BLOCK_SIDE = 8;
/** Pixels side by side, the least that a dispatch traces: what a software adapter does at once. */
export const STRIP_PIXELS = 4;
/** Strips of a block. */
export const BLOCK_STRIPS = BLOCK_SIDE ** 2 / STRIP_PIXELS;
