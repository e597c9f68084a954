// Light from infinitely far away: from a point of the sky, or uniform from a disk in it.
//
// A disk is measured by 1 − cos of its angular radius, and a direction in it by 1 − cos = |d − axis|²/2, so that one as small as
// the sun's keeps its digits.
import package::constants::{FAR, NEAR2, NONE, TWO_PI};
import package::directions::circle;
import package::lights::light::{Light, LightSample};
import package::minMax::greater;
import package::scene::{FIRST_SKY_LIGHT, LIGHT_COUNT, lightAt};

// Of a light that shines along −normal. Its size is 1 − cos of the disk's radius, 0 for a point; its edges complete the frame.
fn sampleSky(light: Light, u: vec2f) -> LightSample {
  @if(!SKY_DISKS) return LightSample(light.normal, FAR, vec3f(1.0), 0.0, NONE, 0.0);
  @if(SKY_DISKS) {
    if (light.size == 0.0) { return LightSample(light.normal, FAR, vec3f(1.0), 0.0, NONE, 0.0); }
    let oneMinusCos = u.x * light.size;
    let cosTheta = 1.0 - oneMinusCos;
    let around = sqrt(oneMinusCos * (1.0 + cosTheta)) * circle(u.y);
    let wi = normalize(around.x * light.edge1 + around.y * light.edge2 + cosTheta * light.normal);
    let solidAngle = TWO_PI * light.size;
    return LightSample(wi, FAR, vec3f(solidAngle), 1.0 / solidAngle, NONE, 0.0);
  }
}

// Density of sampleSky towards a direction; 0 outside of the disk.
fn skyLightPdf(light: Light, d: vec3f) -> f32 {
  let away = d - light.normal;
  return select(0.0, 1.0 / greater(TWO_PI * light.size, NEAR2), dot(away, away) < 2.0 * light.size);
}

// Radiance of all disks that a ray meets when it escapes.
@if(SKY_DISKS)
fn skyRadiance(d: vec3f) -> vec3f {
  var L = vec3f(0.0);
  for (var i = FIRST_SKY_LIGHT; i < LIGHT_COUNT; i++) {
    let light = lightAt(i);
    L += select(vec3f(0.0), light.radiance, skyLightPdf(light, d) > 0.0);
  }
  return L;
}
