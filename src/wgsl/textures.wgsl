// Textures of meshes, filtered here: texels are in one buffer, so that pictures of any size and number need one binding, and
// nothing is scaled. Level 0 only: a pixel's samples filter it.
import package::constants::NONE;
import package::minMax::{greater, lesser};
import package::scene::{factorsOf, textureOf};
import package::uvs::Uvs;

// Red, green, blue, alpha of all textures, a byte each from the lowest on; rows from the top. Written by the renderer when the
// geometry changes.
@if(TEXTURES)
@group(0) @binding(10) var<storage, read> texels: array<u32>;

// One texture, with UV_TRANSFORMS in one of its places; packed by tree/textureTables.ts.
struct Texture {
  // Width, height, index of the first texel.
  place: vec3u,
  // What lies left and right, above and below: WRAP_REPEAT, WRAP_MIRROR or WRAP_CLAMP.
  wrapU: u32,
  wrapV: u32,
  // 1 to take the nearest texel, 0 to interpolate.
  nearest: u32,
  // Which texture coordinates it is looked up with: 0 or 1.
  @if(UV_TRANSFORMS) uv: u32,
  // Rows of the matrix that makes its own coordinates of (u, v, 1).
  @if(UV_TRANSFORMS) toU: vec3f,
  @if(UV_TRANSFORMS) toV: vec3f,
}

const WRAP_REPEAT = 0u;
const WRAP_MIRROR = 1u;

// Four texels around a point, left and right of it in the upper and then in the lower row, and how far it is from the first.
struct Footprint {
  texels: vec4u,
  share: vec2f,
}

// A colour, from sRGB.
@if(TEXTURES)
fn colorAt(texture: u32, uv: Uvs) -> vec3f {
  if (texture == NONE) { return vec3f(1.0); }
  let f = footprint(textureOf(texture), uv);
  return bilinear(linearOf(valueOf(f.texels.x)), linearOf(valueOf(f.texels.y)), linearOf(valueOf(f.texels.z)),
    linearOf(valueOf(f.texels.w)), f.share);
}

// Data, as it is.
@if(TEXTURES)
fn dataAt(texture: u32, uv: Uvs) -> vec3f {
  if (texture == NONE) { return vec3f(1.0); }
  let f = footprint(textureOf(texture), uv);
  return bilinear(valueOf(f.texels.x), valueOf(f.texels.y), valueOf(f.texels.z), valueOf(f.texels.w), f.share);
}

// Its alpha.
@if(TEXTURES)
fn alphaAt(texture: u32, uv: Uvs) -> f32 {
  if (texture == NONE) { return 1.0; }
  let f = footprint(textureOf(texture), uv);
  let alphas = vec4f(f.texels >> vec4u(24u)) / 255.0;
  return mix(mix(alphas.x, alphas.y, f.share.x), mix(alphas.z, alphas.w, f.share.x), f.share.y);
}

@if(TEXTURES)
fn footprint(texture: Texture, given: Uvs) -> Footprint {
  @if(!UV_TRANSFORMS) let uv = given;
  @if(UV_TRANSFORMS) let uv = uvTurned(texture, select(given.xy, given.zw, texture.uv == 1u)) + vec2f(texture.toU.z, texture.toV.z);
  let size = vec2f(texture.place.xy);
  let place = vec2f(fold(uv.x, texture.wrapU), fold(uv.y, texture.wrapV)) * size - 0.5;
  let corner = floor(select(place, place + 0.5, texture.nearest == 1u));
  let share = select(place - corner, vec2f(0.0), texture.nearest == 1u);
  let x = vec2u(column(corner.x, size.x, texture.wrapU), column(corner.x + 1.0, size.x, texture.wrapU));
  let y = vec2u(column(corner.y, size.y, texture.wrapV), column(corner.y + 1.0, size.y, texture.wrapV));
  let rows = texture.place.z + y * texture.place.x;
  return Footprint(vec4u(texels[rows.x + x.x], texels[rows.x + x.y], texels[rows.y + x.x], texels[rows.y + x.y]), share);
}

// What a step in its texture coordinates is in a texture's own.
@if(UV_TRANSFORMS)
fn uvTurned(texture: Texture, along: vec2f) -> vec2f {
  return vec2f(dot(texture.toU.xy, along), dot(texture.toV.xy, along));
}

fn bilinear(a: vec3f, b: vec3f, c: vec3f, d: vec3f, share: vec2f) -> vec3f {
  return mix(mix(a, b, share.x), mix(c, d, share.x), share.y);
}

// A texture coordinate within 0…1.
fn fold(u: f32, wrap: u32) -> f32 {
  let mirrored = 1.0 - abs(2.0 * fract(0.5 * u) - 1.0);
  return select(select(lesser(greater(u, 0.0), 1.0), mirrored, wrap == WRAP_MIRROR), fract(u), wrap == WRAP_REPEAT);
}

// A column or row of `count`, of which one past either end may be asked for.
fn column(i: f32, count: f32, wrap: u32) -> u32 {
  let last = count - 1.0;
  let isRepeated = wrap == WRAP_REPEAT;
  return u32(select(select(i, select(last, 0.0, isRepeated), i > last), select(0.0, last, isRepeated), i < 0.0));
}

fn valueOf(texel: u32) -> vec3f {
  return unpack4x8unorm(texel).rgb;
}

// sRGB, IEC 61966-2-1.
fn linearOf(c: vec3f) -> vec3f {
  return select(pow((c + 0.055) / 1.055, vec3f(2.4)), c / 12.92, c <= vec3f(0.04045));
}
