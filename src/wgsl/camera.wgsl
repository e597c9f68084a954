import package::constants::NONE;
import package::dimensions::PIXEL;
import package::ray::{Ray, makeRay};
import package::sampler::{Sampler, point};
import package::uniforms::frame;

// A ray through a uniform point of the pixel. Pixel (0, 0) is at the top left.
fn cameraRay(pixel: vec2u, samples: Sampler) -> Ray {
  let position = (vec2f(pixel) + point(samples, PIXEL)) / vec2f(frame.size) * 2.0 - 1.0;
  return makeRay(frame.origin, normalize(frame.forward + position.x * frame.right - position.y * frame.up), NONE);
}
