// What a ray finds where it hits.
import package::box::boxNormal;
import package::bsdf::{Bsdf, specularShare};
import package::constants::{INSIDE, NONE};
import package::frame::{Frame, frameAround, toLocal};
import package::lights::sphereLightPdf;
import package::mesh::{MeshPoint, consistentNormal, meshPoint};
import package::multiscatter::multiscatterGain;
import package::order::greater;
import package::ray::{Hit, Ray};
import package::tree::{BOX, Item, TURNED_TRIANGLE, itemAt};
import package::textures::{colorAt, dataAt};
import package::scene::{F0Of, PRIMITIVES, factorsOf, alphaOf, anchorOf, diffuseOf, emissionOf, f0Of, f90Of, lightDensityOf, multiscatterOf, schlickBeckmannOf, shapeNormal, shapeOf};

// Packed by compile/packScene.ts, one per primitive.
struct Material {
  F0: vec3f,
  alpha: f32,
  diffuse: vec3f,
  f0: f32,
  emission: vec3f,
  // Density of light sampling: per area on flat emitters, 1 on spheres; 0 if never sampled. Where there are many lights, times
  // the light's strength: to be multiplied by lightShareOf() and divided by the weight of all lights.
  lightDensity: f32,
  f90: f32,
  // 1 for the masking "schlick-beckmann", else 0.
  schlickBeckmann: f32,
  // Share of the light lost to multiple scattering that is given back: `metallic`, or 0 without the flag.
  multiscatter: f32,
}

struct Surface {
  p: vec3f,
  // n on the viewer's side.
  frame: Frame,
  // Of the surface itself, on the viewer's side, where n may be an interpolated one.
  @if(SHADING_NORMALS) ng: vec3f,
  // Towards the viewer, in the local frame.
  wo: vec3f,
  bsdf: Bsdf,
  // Radiance towards the viewer; only the front side emits.
  Le: vec3f,
  // Density, per steradian, with which light sampling at the ray's origin finds this point, but for the choice of light.
  lightPdf: f32,
  // What a ray that leaves from here names as its source.
  source: u32,
}

fn surfaceAt(ray: Ray, hit: Hit) -> Surface {
  var id = hit.id;
  @if(TREE) var item: Item;
  @if(TREE) let isItem = hit.id >= PRIMITIVES;
  @if(TREE) {
    if (isItem) {
      item = itemAt(hit.id - PRIMITIVES);
      id = item.id;
    }
  }
  @if(MESHES) let isTriangle = isItem & (item.kind <= TURNED_TRIANGLE);
  @if(MESHES) var triangle: MeshPoint;
  @if(MESHES) {
    if (isTriangle) { triangle = meshPoint(ray, hit.t, hit.id - PRIMITIVES, item); }
  }
  let shape = shapeOf(id);
  var p = ray.o + hit.t * ray.d;
  var n = shape.xyz;
  @if(RIMS) {
    // Back onto the plane, and by a few ULP towards the middle: a point on the edge of a wall then lies on the inner side of
    // the next wall, where the ray that found it came from.
    let anchor = anchorOf(id);
    let q = p - anchor.xyz;
    p = select(p, anchor.xyz + anchor.w * (q - dot(q, n) * n), shape.w == 0.0);
  }
  @if(SPHERES) let isSphere = shape.w > 0.0;
  @if(HUGE_SPHERES) let isHuge = isSphere & (anchorOf(id).w > 0.0);
  @if(HUGE_SPHERES) let flight = p;
  @if(SPHERES) {
    // Back onto the sphere: the point is then as exact as the radius, however far the ray came.
    let radial = normalize(select(n, p - shape.xyz, isSphere));
    p = select(p, shape.xyz + shape.w * radial, isSphere);
    n = radial;
  }
  @if(HUGE_SPHERES) {
    let anchor = anchorOf(id);
    let g = flight - anchor.xyz;
    let spoke = anchor.xyz - shape.xyz;
    let f = g + spoke;
    let height = dot(g, g + 2.0 * spoke) / (length(f) + shape.w);
    n = select(n, normalize(f), isHuge);
    p = select(p, flight - height * n, isHuge);
  }
  @if(BOXES) n = shapeNormal(ray, id, p, n);
  @if(TREE_BOXES) {
    if (isItem & (item.kind == BOX)) { n = boxNormal(ray, p, item.a, item.b, item.c.xy, hit.id); }
  }
  @if(MESHES) n = select(n, triangle.n, isTriangle);
  let cosine = -dot(ray.d, n);
  var front = cosine > 0.0;
  @if(SPHERES) {
    // A sphere is met from the side the ray starts on; at grazing angles rounding would have it otherwise now and then. Of a
    // huge one the origin's side is the less certain.
    let toOrigin = ray.o - shape.xyz;
    let startsInside = (ray.source == (hit.id | INSIDE)) | (dot(toOrigin, toOrigin) < shape.w * shape.w);
    @if(!HUGE_SPHERES) front = select(front, !startsInside, isSphere);
    @if(HUGE_SPHERES) front = select(front, !startsInside, isSphere & !isHuge);
  }

  var surface: Surface;
  surface.p = p;
  var facing = select(-n, n, front);
  @if(MESHES) surface.p = select(p, triangle.p + triangle.clearance * facing, isTriangle);
  @if(SHADING_NORMALS) {
    surface.ng = facing;
    let shading = select(-triangle.shading, triangle.shading, front);
    facing = select(facing, consistentNormal(shading, facing, -ray.d), isTriangle);
  }
  surface.frame = frameAround(facing);
  surface.wo = toLocal(surface.frame, -ray.d);
  var uv = vec2f(0.0);
  @if(TEXTURES) uv = triangle.uv;
  surface.bsdf = bsdfOf(id, surface.wo.z, uv);
  @if(EMISSION) {
    surface.Le = select(vec3f(0.0), emissionOf(id), front);
    @if(EMISSION_TEXTURES) surface.Le *= colorAt(factorsOf(id).emissionTexture, uv);
    surface.lightPdf = lightPdf(lightDensityOf(id), shape, ray, hit.t, cosine);
  }
  surface.source = hit.id;
  // Only a closed shape can be hit again from where the ray leaves it.
  @if((SPHERES || BOXES) && !MESHES) surface.source |= select(INSIDE, 0u, front || shape.w == 0.0);
  @if((SPHERES || BOXES) && MESHES) surface.source |= select(INSIDE, 0u, front || shape.w == 0.0 || isTriangle);
  return surface;
}

// The primitive of what a ray hits: of a triangle of a mesh, the mesh.
fn primitiveOf(id: u32) -> u32 {
  @if(TREE) return select(id, itemAt(id - PRIMITIVES).id, id >= PRIMITIVES);
  @if(!TREE) return id;
}

// How a primitive scatters, seen under cosO, at texture coordinates. Reads only what the scene's materials make use of: every
// field costs a gather.
fn bsdfOf(id: u32, cosO: f32, uv: vec2f) -> Bsdf {
  var bsdf: Bsdf;
  @if(DIFFUSE) bsdf.diffuse = diffuseOf(id);
  @if(SPECULAR) {
    bsdf.F0 = F0Of(id);
    bsdf.f0 = f0Of(id);
    bsdf.f90 = f90Of(id);
    bsdf.alpha = alphaOf(id);
  }
  @if(MULTISCATTER) var multiscatter = multiscatterOf(id);
  @if(SURFACE_TEXTURES) {
    let factors = factorsOf(id);
    let base = factors.baseColor * colorAt(factors.baseColorTexture, uv);
    let data = dataAt(factors.metallicRoughnessTexture, uv);
    let metallic = factors.metallic * data.b;
    let roughness = factors.roughness * data.g;
    @if(DIFFUSE) bsdf.diffuse = (1.0 - metallic) * base;
    @if(SPECULAR) {
      let isTextured = min(factors.baseColorTexture, factors.metallicRoughnessTexture) != NONE;
      bsdf.F0 = select(bsdf.F0, mix(vec3f(bsdf.f0), base, metallic), isTextured);
      // A texture makes no perfect mirrors: α stays at what compile/features.ts takes for one.
      bsdf.alpha = select(bsdf.alpha, max(roughness * roughness, 0x1p-24), isTextured);
    }
    @if(MULTISCATTER) multiscatter *= data.b;
  }
  @if(SMITH && SCHLICK_BECKMANN) bsdf.schlickBeckmann = schlickBeckmannOf(id);
  @if(MULTISCATTER) bsdf.gain = multiscatterGain(cosO, bsdf.alpha, bsdf.F0 * multiscatter);
  bsdf.specularShare = specularShare(bsdf, cosO);
  return bsdf;
}

@if(EMISSION)
fn lightPdf(density: f32, shape: vec4f, ray: Ray, t: f32, cosine: f32) -> f32 {
  let flat = density * t * t / greater(abs(cosine), 1e-18);
  @if(SPHERE_EMITTERS) return select(flat, density * sphereLightPdf(ray.o, shape.xyz, shape.w), shape.w > 0.0);
  @if(!SPHERE_EMITTERS) return flat;
}
