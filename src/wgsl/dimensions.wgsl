// Which two-dimensional sample point decides what: a fixed layout per bounce, so that a decision keeps its points
// whatever the decisions before it were.

const PIXEL = 0u;
// Of the rays that look for emitters.
const EMITTER_PIXEL = 0x80000000u;
// Where on the lens, of paths and of those rays.
const LENS_POINT = 0x10000000u;
const EMITTER_LENS_POINT = 0x90000000u;
const LIGHT = 1u;
// Added to the dimension of LIGHT: which part of a light of many parts.
const LIGHT_PICK = 0x20000000u;
const DIRECTION = 2u;
// x: lobe, y: roulette.
const LOBE = 3u;
const PER_BOUNCE = 3u;

fn dimensionAt(depth: u32, decision: u32) -> u32 {
  return depth * PER_BOUNCE + decision;
}
