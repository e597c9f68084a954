// What a ray finds on a triangle of a mesh.
//
// [1] Pharr, Jakob, Humphreys 2023, "Physically Based Rendering", 4th ed., section 6.8.4
// [2] Keller et al. 2017, "The Iray Light Transport Simulation and Rendering System", appendix A.3
// [3] Cigolle et al. 2014, "A Survey of Efficient Representations for Independent Unit Vectors", JCGT 3(2)
// [4] Hanika 2021, "Hacking the Shadow Terminator", Ray Tracing Gems II ch. 4
import package::constants::NONE;
import package::minMax::{greater, lesser};
import package::ray::Ray;
import package::scene::{COLOR_AT, TANGENT_AT, UVS1_AT, VERTEX_STRIDE, coatNormalScaleOf, factorsOf, textureOf};
import package::textures::{dataAt, uvTurned};
import package::tree::{Item, TURNED_TRIANGLE};
import package::uvs::Uvs;

// Of each triangle the normals of its three vertices, octahedral, two snorm16 each. By slot. Written by the renderer when the
// geometry changes.
@if(SMOOTH)
@group(0) @binding(7) var<storage, read> normals: array<u32>;

// Likewise what else vertices have, in pairs of f32: see tree/vertexLayout.ts. Written by the renderer when the geometry changes.
@if(VERTICES)
@group(0) @binding(9) var<storage, read> vertices: array<vec2f>;

// [1] eq. 6.15 bounds the rounding of a point of barycentric coordinates by γ₇, 7 half ULP, of the sum below; a WGSL device
// may round either way, which makes it 7 ULP, and what is added to the point is itself rounded once more.
const POINT_ERROR = 0x1.4p-20;

// Draws points this much of the way to the triangle's middle, at most: no more than a hundredth of a pixel where a triangle
// spans three.
const MAX_STEP = 0x1p-8;

// Of unit edges, the cross product of a triangle two of whose corners are one in f32.
const LINE = 0x1p-60;

// Length of a sum of unit normals that has no digits left but rounding.
const CANCELLED = 1e-6;

// Of a tangent, or of the square of a normal that a texture tells: too short to have a direction.
const NO_DIRECTION = 1e-12;

struct MeshPoint {
  // Within the triangle, and not on its edges.
  p: vec3f,
  // Of the triangle's front, unit.
  n: vec3f,
  // How far rays that leave from p must start off the surface, so that rounding puts none on its other side.
  clearance: f32,
  // Interpolated and bent by a texture, unit, on n's side.
  @if(SHADING_NORMALS) shading: vec3f,
  // Interpolated alone, unit, on n's side, where a texture bends it.
  @if(SMOOTH && NORMAL_TEXTURES) smoothN: vec3f,
  // Interpolated, and bent by the texture of a clear coat, unit, on n's side.
  @if(COAT_NORMAL) coatN: vec3f,
  // The way of growing u along the front, and across it, of any length; zero where there is none.
  @if(MESH_STRETCH) tangent: vec3f,
  @if(MESH_STRETCH) bitangent: vec3f,
  // From p to the smooth surface that the vertices' normals tell of, on the side of the ray's origin; zero where that is hollow. [4]
  @if(SMOOTH) lift: vec3f,
  // Interpolated.
  @if(TEXTURES) uv: Uvs,
  @if(COLORS) color: vec4f,
}

fn meshPoint(ray: Ray, t: f32, slot: u32, item: Item) -> MeshPoint {
  let edge1 = item.b - item.a;
  let edge2 = item.c - item.a;
  let edge3 = item.c - item.b;
  let longest = sqrt(greater(dot(edge1, edge1), greater(dot(edge2, edge2), dot(edge3, edge3))));
  // In units of the longest edge, so that no product underflows.
  let e1 = edge1 / longest;
  let e2 = edge2 / longest;
  let area = cross(e1, e2);
  // Two of whose corners are one in f32, beside a third that is far off: any normal will do, and any point.
  let isLine = all(abs(area) < vec3f(LINE));
  let twiceArea = select(length(area), 1.0, isLine);
  let normal = select(area / twiceArea, -ray.d, isLine);

  // Barycentric coordinates of where the ray is, rid of its distance's rounding.
  let q = (ray.o + t * ray.d - item.a) / longest;
  let along = vec2f(dot(cross(q, e2), normal), dot(cross(e1, q), normal)) / twiceArea;
  var weights = greater3(vec3f(1.0 - along.x - along.y, along), vec3f(0.0));
  weights /= weights.x + weights.y + weights.z;
  let error = POINT_ERROR * greater3(greater3(abs(item.a), abs(item.b)), abs(item.c));
  let toEdge = longest * twiceArea / 3.0;
  weights = mix(weights, vec3f(1.0 / 3.0), lesser(4.0 * length(error) / toEdge, MAX_STEP));

  var found: MeshPoint;
  found.p = weights.x * item.a + weights.y * item.b + weights.z * item.c;
  found.n = select(normal, -normal, item.kind == TURNED_TRIANGLE);
  found.clearance = dot(abs(normal), error);
  @if(TEXTURES) found.uv = uvAt(slot, weights);
  @if(COLORS) found.color = colorOn(slot, weights);
  @if(COAT_NORMAL) found.coatN = found.n;
  @if(MESH_STRETCH) {
    @if(!STRETCH_TEXTURES) let texture = NONE;
    @if(STRETCH_TEXTURES) let texture = factorsOf(item.id).anisotropyTexture;
    let tangents = tangentsAt(slot, weights, texture, found.n, e1, e2);
    found.tangent = tangents.t;
    found.bitangent = tangents.b;
  }
  @if(SHADING_NORMALS) {
    var shading = found.n;
    @if(SMOOTH) {
      let side = select(-1.0, 1.0, dot(ray.d, found.n) < 0.0);
      let na = vertexNormal(slot, 0u);
      let nb = vertexNormal(slot, 1u);
      let nc = vertexNormal(slot, 2u);
      shading = interpolatedNormal(weights.x * na + weights.y * nb + weights.z * nc, found.n);
      @if(NORMAL_TEXTURES) found.smoothN = select(shading, -shading, dot(shading, found.n) < 0.0);
      @if(COAT_NORMAL) found.coatN = found.smoothN;
      found.lift = weights.x * liftTo(side * dot(found.p - item.a, na), side * na) +
        weights.y * liftTo(side * dot(found.p - item.b, nb), side * nb) +
        weights.z * liftTo(side * dot(found.p - item.c, nc), side * nc);
    }
    @if(NORMAL_TEXTURES || COAT_NORMAL_TEXTURE) let factors = factorsOf(item.id);
    @if(COAT_NORMAL_TEXTURE) {
      let bent = texturedNormal(slot, weights, factors.clearcoatNormalTexture, coatNormalScaleOf(item.id), found.uv, shading, e1, e2);
      found.coatN = select(bent, -bent, dot(bent, found.n) < 0.0);
    }
    @if(NORMAL_TEXTURES) shading = texturedNormal(slot, weights, factors.normalTexture, factors.normalScale, found.uv, shading, e1, e2);
    found.shading = select(shading, -shading, dot(shading, found.n) < 0.0);
  }
  return found;
}

fn greater3(a: vec3f, b: vec3f) -> vec3f {
  return select(b, a, a > b);
}

@if(SMOOTH)
fn interpolatedNormal(sum: vec3f, n: vec3f) -> vec3f {
  let size = length(sum);
  return select(n, sum / size, size > CANCELLED); // opposite normals may cancel out
}

@if(SMOOTH)
fn vertexNormal(slot: u32, corner: u32) -> vec3f {
  return octahedral(normals[3u * slot + corner]);
}

// From a point below the plane through a vertex onto that plane, by its height above it. [4]
@if(SMOOTH)
fn liftTo(height: f32, n: vec3f) -> vec3f {
  return -lesser(height, 0.0) * n;
}

@if(TEXTURES && !UV_TRANSFORMS)
fn uvAt(slot: u32, weights: vec3f) -> Uvs {
  return weights.x * vertexPart(slot, 0u, 0u) + weights.y * vertexPart(slot, 1u, 0u) + weights.z * vertexPart(slot, 2u, 0u);
}

@if(UV_TRANSFORMS)
fn uvAt(slot: u32, weights: vec3f) -> Uvs {
  return vec4f(pairOn(slot, weights, 0u), pairOn(slot, weights, UVS1_AT));
}

// A pair, interpolated.
@if(UV_TRANSFORMS)
fn pairOn(slot: u32, weights: vec3f, at: u32) -> vec2f {
  return weights.x * vertexPart(slot, 0u, at) + weights.y * vertexPart(slot, 1u, at) + weights.z * vertexPart(slot, 2u, at);
}

// A pair of what a corner of a triangle has.
@if(VERTICES)
fn vertexPart(slot: u32, corner: u32, at: u32) -> vec2f {
  return vertices[(3u * slot + corner) * VERTEX_STRIDE + at];
}

@if(COLORS)
fn colorOn(slot: u32, weights: vec3f) -> vec4f {
  return quadOn(slot, weights, COLOR_AT);
}

// Two pairs, interpolated.
@if(COLORS || TANGENTS)
fn quadOn(slot: u32, weights: vec3f, at: u32) -> vec4f {
  var sum = vec4f(0.0);
  for (var i = 0u; i < 3u; i++) { sum += weights[i] * vec4f(vertexPart(slot, i, at), vertexPart(slot, i, at + 1u)); }
  return sum;
}

// The directions of a texture along a surface of normal n, in glTF's tangent space: along growing u, and along falling v. Unit;
// zero where the texture is stretched over no area.
struct Tangents {
  t: vec3f,
  b: vec3f,
}

// Of the texture's coordinates; NONE for the first ones as they are. e1 and e2 are the triangle's edges from its first vertex, in any unit.
fn tangentsAt(slot: u32, weights: vec3f, texture: u32, n: vec3f, e1: vec3f, e2: vec3f) -> Tangents {
  @if(!UV_TRANSFORMS) let d1 = vertexPart(slot, 1u, 0u) - vertexPart(slot, 0u, 0u);
  @if(!UV_TRANSFORMS) let d2 = vertexPart(slot, 2u, 0u) - vertexPart(slot, 0u, 0u);
  @if(UV_TRANSFORMS) var at = 0u;
  @if(UV_TRANSFORMS) if (texture != NONE) { at = textureOf(texture).uv * UVS1_AT; }
  @if(UV_TRANSFORMS) var d1 = vertexPart(slot, 1u, at) - vertexPart(slot, 0u, at);
  @if(UV_TRANSFORMS) var d2 = vertexPart(slot, 2u, at) - vertexPart(slot, 0u, at);
  @if(UV_TRANSFORMS) if (texture != NONE) {
    d1 = uvTurned(textureOf(texture), d1);
    d2 = uvTurned(textureOf(texture), d2);
  }
  let turn = sign(d1.x * d2.y - d1.y * d2.x);
  let alongU = (e1 * d2.y - e2 * d1.y) * turn;
  let alongV = (e2 * d1.x - e1 * d2.x) * turn;
  @if(!TANGENTS) let along = alongU;
  @if(TANGENTS) let given = quadOn(slot, weights, TANGENT_AT);
  @if(TANGENTS) let along = select(alongU, given.xyz, given.w != 0.0);
  let flat = along - dot(along, n) * n;
  let size = length(flat);
  if (size < NO_DIRECTION) { return Tangents(vec3f(0.0), vec3f(0.0)); }
  let tangent = flat / size;
  let side = cross(n, tangent);
  @if(!TANGENTS) let isOther = dot(side, alongV) > 0.0;
  @if(TANGENTS) let isOther = select(dot(side, alongV) > 0.0, given.w < 0.0, given.w != 0.0);
  return Tangents(tangent, select(side, -side, isOther));
}

// The normal that a texture tells.
fn texturedNormal(slot: u32, weights: vec3f, texture: u32, scale: f32, uv: Uvs, n: vec3f, e1: vec3f, e2: vec3f) -> vec3f {
  if (texture == NONE) { return n; }
  let along = tangentsAt(slot, weights, texture, n, e1, e2);
  if (all(along.t == vec3f(0.0))) { return n; }
  let told = 2.0 * dataAt(texture, uv) - 1.0;
  let bent = scale * (told.x * along.t + told.y * along.b) + told.z * n;
  return normalize(select(bent, n, dot(bent, bent) < NO_DIRECTION));
}

// Of a vertex without a normal: its triangles are flat.
const NO_NORMAL = 0x80008000u;

// [3]
@if(SMOOTH)
fn octahedral(packed: u32) -> vec3f {
  let e = unpack2x16snorm(packed);
  let z = 1.0 - abs(e.x) - abs(e.y);
  let folded = (1.0 - abs(e.yx)) * select(vec2f(-1.0), vec2f(1.0), e >= vec2f(0.0));
  let unit = normalize(vec3f(select(folded, e, z >= 0.0), z));
  return select(unit, vec3f(0.0), packed == NO_NORMAL);
}

// A shading normal may face away from a viewer who sees the triangle, or mirror him into it: he would see black. Bent just far
// enough that the mirror direction leaves the surface. All unit; n on the viewer's side. [2]
@if(SHADING_NORMALS)
fn consistentNormal(shading: vec3f, n: vec3f, wo: vec3f) -> vec3f {
  let mirrored = reflect(-wo, shading);
  // What the mirror direction's cosine should be at least; less where the view itself is more grazing.
  let least = lesser(0.01, 0.9 * dot(wo, n));
  let missing = least - dot(mirrored, n);
  let bent = normalize(wo + normalize(mirrored + missing * n));
  return select(shading, bent, missing > 0.0);
}
