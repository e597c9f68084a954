import package::constants::NONE;
import package::ray::{Ray, makeRay};
import package::frameUniforms::frame;

// A ray through point u in [0, 1)² of the pixel. Pixel (0, 0) is at the top left. It starts where the scene begins, so that
// distances, and with them the digits of what it hits, are the scene's own, however far the camera is.
fn cameraRay(pixel: vec2u, u: vec2f) -> Ray {
  let position = (vec2f(pixel) + u) / vec2f(frame.size) * 2.0 - 1.0;
  let offset = position.x * frame.right - position.y * frame.up;
  return makeRay(frame.origin + frame.near * offset, normalize(frame.forward + offset), NONE);
}
