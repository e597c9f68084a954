// Which way an anisotropic surface stretches its reflections, in world space: across its grooves.
import package::scene::{factorsOf, stretchOf};
import package::surfacePoint::SurfacePoint;
import package::textures::dataAt;

// Along the tangent of a mesh that has texture coordinates, turned; of other shapes, and where those have no directions, along the
// horizontal, turned: as of what has upright grooves.
fn stretchAlong(found: SurfacePoint) -> vec3f {
  let turn = stretchOf(found.id);
  let across = cross(vec3f(0.0, 1.0, 0.0), found.n);
  var t = across;
  var b = cross(found.n, across);
  var along = turn.xy;
  @if(MESH_STRETCH) {
    let has = any(found.tangent != vec3f(0.0));
    t = select(t, found.tangent, has);
    b = select(b, found.bitangent, has);
  }
  @if(STRETCH_TEXTURES) {
    let told = 2.0 * dataAt(factorsOf(found.id).anisotropyTexture, found.uv).xy - 1.0;
    // White, where there is no texture, is none either.
    let direction = select(told, vec2f(1.0, 0.0), all(told == vec2f(1.0)));
    along = vec2f(turn.x * direction.x - turn.y * direction.y, turn.y * direction.x + turn.x * direction.y);
  }
  return along.x * t + along.y * b;
}
