// Which pixels a dispatch traces. The film is covered by blocks of 8 × 8 pixels, a workgroup each, and a block by 16 strips of
// 4 pixels side by side. A dispatch takes some of the strips, in an order that spreads them over the whole picture: see
// renderer/schedule.ts, which chooses it.
import package::frameUniforms::frame;

const BLOCK_SIDE = 8u;
const STRIP_PIXELS = 4u;
const BLOCK_STRIPS = 16u;

// The pixel of an invocation, by its workgroup's place among all and its own within; outside of the film if it has none.
fn slicePixel(group: vec3u, groups: vec3u, lane: u32) -> vec2u {
  let firstBlock = frame.firstStrip / BLOCK_STRIPS;
  let strip = (firstBlock + group.y * groups.x + group.x) * BLOCK_STRIPS + lane / STRIP_PIXELS;
  if (strip < frame.firstStrip || strip >= frame.endStrip) { return frame.size; }

  let size = (frame.size + BLOCK_SIDE - 1u) / BLOCK_SIDE;
  let units = size.x * size.y * BLOCK_STRIPS / frame.unitStrips;
  let unit = (strip / frame.unitStrips) * frame.unitStride % units;
  let place = unit * frame.unitStrips + strip % frame.unitStrips;

  let block = place / BLOCK_STRIPS;
  let pixel = (place % BLOCK_STRIPS) * STRIP_PIXELS + lane % STRIP_PIXELS;
  return BLOCK_SIDE * vec2u(block % size.x, block / size.x) + vec2u(pixel % BLOCK_SIDE, pixel / BLOCK_SIDE);
}
