// What changes from dispatch to dispatch. Mirrored by FRAME in compile/layouts.ts.

struct FrameUniforms {
  // Centre of the plane where camera rays start, in the compiled scene's coordinates.
  origin: vec3f,
  // Samples per pixel in this dispatch.
  sampleCount: u32,
  // From the camera to the centre of the image plane, and from there to its right and upper edge.
  forward: vec3f,
  // Index of the dispatch's first sample within the film half.
  firstSample: u32,
  right: vec3f,
  // Half of the film that this dispatch adds to: 0 or 1.
  half: u32,
  up: vec3f,
  seed: u32,
  // Of the film, in pixels.
  size: vec2u,
  // What of the film this dispatch traces: see slice.wgsl.
  firstStrip: u32,
  endStrip: u32,
  unitStrips: u32,
  unitStride: u32,
  maxBounces: u32,
  lightSamples: u32,
  // Distance of `origin` from the camera in image planes. Nothing in view lies closer: see rayStart in renderer/cameraBasis.ts.
  near: f32,
  // Outside of these pixels, from the first to before the second, the camera sees no emitter.
  emittersFrom: vec2u,
  emittersTo: vec2u,
  // Radius of the lens as seen where rays start, and by how much their slope changes from its middle to its edge: see lens.wgsl.
  @if(LENS) lens: vec2f,
}

@group(0) @binding(0) var<uniform> frame: FrameUniforms;

// Rays traced by this invocation.
var<private> rayCount: u32;

fn countRay() {
  rayCount++;
}
