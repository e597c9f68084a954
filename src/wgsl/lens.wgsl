// A thin lens: rays through one point of the picture start all over the lens, and meet again in the plane of focus.
import package::constants::NONE;
import package::directions::circle;
import package::frameUniforms::frame;
import package::ray::{Ray, makeRay};

// A ray through point u in [0, 1)² of the pixel, and a point of the lens, uniform on its disk for a uniform v. It starts where the
// scene begins, as in camera.wgsl.
fn lensRay(pixel: vec2u, u: vec2f, v: vec2f) -> Ray {
  let size = vec2f(frame.size);
  let position = (vec2f(pixel) + u) / size * 2.0 - 1.0;
  // In image plane coordinates, whose unit is as long as the picture is wide, or high.
  let onLens = sqrt(v.x) * circle(v.y) * vec2f(size.y / size.x, 1.0);
  let start = frame.near * position + frame.lens.x * onLens;
  let slope = position - frame.lens.y * onLens;
  return makeRay(frame.origin + inScene(start), normalize(frame.forward + inScene(slope)), NONE);
}

fn inScene(offset: vec2f) -> vec3f {
  return offset.x * frame.right - offset.y * frame.up;
}
