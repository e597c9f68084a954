// Points on meshes that emit.
//
// [1] Walker 1977, "An Efficient Method for Generating Discrete Random Variables with General Distributions", TOMS 3(3)
import package::lights::area::{fromArea, squareToTriangle};
import package::lights::light::{Light, LightSample};
import package::shapes::mesh::{LINE, colorOn, uvAt};
import package::scene::{PRIMITIVES, factorsOf, unlitOf};
import package::textures::colorAt;
import package::tree::{TURNED_TRIANGLE, itemAt};

// A triangle of a mesh by Walker's method: in proportion to their areas, to within a share of 2⁻²⁴ of the mesh's. [1]
struct EmissiveTriangle {
  // Whether this triangle keeps its turn, or gives it to another.
  probability: f32,
  slot: u32,
  other: u32,
  unused: u32,
}

// Written by the renderer when the geometry changes.
@if(LIGHT_PICKS)
@group(0) @binding(8) var<storage, read> emissiveTriangles: array<EmissiveTriangle>;

// Uniform on a mesh's whole surface.
@if(LIGHT_PICKS)
fn sampleMesh(p: vec3f, light: Light, u: vec2f, pick: vec2f) -> LightSample {
  let index = min(u32(pick.x * light.position.y), u32(light.position.y) - 1u);
  let entry = emissiveTriangles[u32(light.position.x) + index];
  let slot = select(entry.other, entry.slot, pick.y < entry.probability);
  let item = itemAt(slot);
  let edge1 = item.b - item.a;
  let edge2 = item.c - item.a;
  // Unit edges first: no product of four lengths. Where two corners are one in f32, beside a third that is far off, it emits
  // from no side.
  let across = cross(normalize(edge1), normalize(edge2)) * select(1.0, -1.0, item.kind == TURNED_TRIANGLE);
  let front = select(normalize(across), vec3f(0.0), all(abs(across) < vec3f(LINE)));
  let at = squareToTriangle(u);
  @if(!DOUBLE_SIDED) var sample = fromArea(p, item.a + at.x * edge1 + at.y * edge2, front, light.size);
  @if(DOUBLE_SIDED) let side = select(front, -front, light.position.z > 0.0);
  @if(DOUBLE_SIDED) var sample = fromArea(p, item.a + at.x * edge1 + at.y * edge2, side, light.size);
  sample.id = PRIMITIVES + slot;
  let weights = vec3f(1.0 - at.x - at.y, at);
  @if(EMISSION_TEXTURES) sample.estimate *= colorAt(factorsOf(item.id).emissionTexture, uvAt(slot, weights));
  @if(UNLIT_COLORS) sample.estimate *= select(vec3f(1.0), colorOn(slot, weights).rgb, unlitOf(item.id) > 0.0);
  return sample;
}
