// Finds what the ray through the middle of the picture hits. To pick another point, the renderer turns the camera to it.
import package::camera::cameraRay;
import package::constants::NONE;
import package::scene::closestHit;
import package::surfacePoint::primitiveOf;

struct Found {
  // Primitive; NONE where there is nothing.
  id: u32,
  // Distance from the ray's start.
  t: f32,
}

// Written here, read by the renderer.
@group(0) @binding(2) var<storage, read_write> found: Found;

@compute @workgroup_size(1)
fn pick() {
  let hit = closestHit(cameraRay(vec2u(0), vec2f(0.5)));
  if (hit.id == NONE) { found = Found(NONE, hit.t); } else { found = Found(primitiveOf(hit.id), hit.t); }
}
