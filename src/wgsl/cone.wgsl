// How much of a surface a path stands for where it meets one: of textures that are smaller than that, the mean is looked up, in a mip
// level, in place of a texel that others of the pixel's samples would not see.
//
// What a path stands for is a cone: of the camera's rays around its pixel, and on after perfect mirrors. [1] A pixel's first sample stands
// for all of it, sample i for as much as one of i samples has to itself: its cone's area is the i-th part. That mean is a bias,
// within the pixel, which ends where texels are no smaller than the cone: a picture tends to that of the textures themselves.
//
// [1] Akenine-Möller et al. 2021, "Improved Shader and Texture Level of Detail Using Ray Cones", JCGT 10(1)
import package::dimensions::MIP_LEVEL;
import package::frameUniforms::frame;
import package::ray::Ray;
import package::sampler::{Sampler, independent, sampleIndex};

// Of the next ray: how wide it is where it starts, and how much wider at distance 1. 0 where it stands for one point.
var<private> cone: vec2f;
// Which of two levels a look-up takes that lies between them.
var<private> levelChance: f32;

// For a ray of the camera.
fn startCone(ray: Ray, samples: Sampler) {
  // Half the picture where rays start, and at distance 1. Of an orthographic camera the square of the latter underflows, as it may.
  let halves = vec2f(length(frame.near * frame.up), dot(ray.d, frame.forward) * length(frame.up));
  // Samples of the film's halves take turns.
  let share = inverseSqrt(2.0 * f32(sampleIndex(samples)) + 1.0);
  cone = share * 2.0 / f32(frame.size.y) * halves;
  levelChance = independent(samples, MIP_LEVEL);
}

// From one hit to the next. Light that is scattered comes from all around; there is nothing to gain from standing for more of it.
fn followCone(distance: f32, pdf: f32) {
  cone = select(vec2f(coneWidth(distance), cone.y), vec2f(0.0), pdf != 0.0);
}

fn coneWidth(distance: f32) -> f32 {
  return cone.x + distance * cone.y;
}
