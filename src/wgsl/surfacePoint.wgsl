// Where a ray meets a surface: by the family that the row of a shape tells, flat, ball or solid, and by triangles of meshes.
import package::constants::INSIDE;
import package::ray::{Hit, Ray};
import package::scene::{PRIMITIVES, anchorOf, cutoffOf, itemNormal, shapeNormal, shapeOf};
import package::shapes::mesh::{MeshPoint, meshPoint};
import package::tree::{Item, TURNED_TRIANGLE, itemAt};
import package::uvs::Uvs;

struct SurfacePoint {
  // As exact as the surface, however far the ray came.
  p: vec3f,
  // Of the front or, of a ball or a solid, outwards; unit.
  n: vec3f,
  // Whether the ray meets the front.
  front: bool,
  // The primitive, and its row in `scene.shapes`.
  id: u32,
  shape: vec4f,
  @if(MESHES) isTriangle: bool,
  // How far rays that leave a triangle of a mesh must start off it, so that rounding puts none on its other side; else 0.
  @if(MESHES) clearance: f32,
  // Of a triangle of a mesh: see MeshPoint.
  @if(SHADING_NORMALS) shading: vec3f,
  @if(SMOOTH && NORMAL_TEXTURES) smoothN: vec3f,
  @if(COAT_NORMAL) coatN: vec3f,
  @if(MESH_STRETCH) tangent: vec3f,
  @if(MESH_STRETCH) bitangent: vec3f,
  @if(SMOOTH) lift: vec3f,
  @if(TEXTURES) uv: Uvs,
  // Of the vertices; white where they have none.
  @if(COLORS) color: vec4f,
}

fn surfacePoint(ray: Ray, hit: Hit) -> SurfacePoint {
  var found: SurfacePoint;
  found.id = hit.id;
  @if(TREE) var item: Item;
  @if(TREE) let isItem = hit.id >= PRIMITIVES;
  @if(TREE) {
    if (isItem) {
      item = itemAt(hit.id - PRIMITIVES);
      found.id = item.id;
    }
  }
  @if(MESHES) found.isTriangle = isItem & (item.kind <= TURNED_TRIANGLE);
  @if(MESHES) var triangle: MeshPoint;
  @if(MESHES) {
    if (found.isTriangle) { triangle = meshPoint(ray, hit.t, hit.id - PRIMITIVES, item); }
  }
  let shape = shapeOf(found.id);
  found.shape = shape;
  var p = ray.o + hit.t * ray.d;
  var n = shape.xyz;
  @if(RIMS) {
    // Back onto the plane, and by a few ULP towards the middle: a point on the edge of a wall then lies on the inner side of
    // the next wall, where the ray that found it came from.
    let anchor = anchorOf(found.id);
    let q = p - anchor.xyz;
    p = select(p, anchor.xyz + anchor.w * (q - dot(q, n) * n), shape.w == 0.0);
  }
  @if(BALLS) let isBall = shape.w > 0.0;
  @if(HUGE_BALLS) let isHuge = isBall & (anchorOf(found.id).w > 0.0);
  @if(HUGE_BALLS) let flight = p;
  @if(BALLS) {
    // Back onto the sphere: the point is then as exact as the radius.
    let radial = normalize(select(n, p - shape.xyz, isBall));
    p = select(p, shape.xyz + shape.w * radial, isBall);
    n = radial;
  }
  @if(HUGE_BALLS) {
    let anchor = anchorOf(found.id);
    let g = flight - anchor.xyz;
    let spoke = anchor.xyz - shape.xyz;
    let f = g + spoke;
    let height = dot(g, g + 2.0 * spoke) / (length(f) + shape.w);
    n = select(n, normalize(f), isHuge);
    p = select(p, flight - height * n, isHuge);
  }
  @if(SOLIDS) n = shapeNormal(ray, found.id, p, n);
  @if(TREE_SOLIDS) {
    if (isItem) { n = itemNormal(ray, hit.id, item, p, n); }
  }
  @if(MESHES) {
    n = select(n, triangle.n, found.isTriangle);
    p = select(p, triangle.p, found.isTriangle);
    found.clearance = triangle.clearance;
  }
  @if(SHADING_NORMALS && MESHES) found.shading = triangle.shading;
  @if(SMOOTH && NORMAL_TEXTURES) found.smoothN = select(n, triangle.smoothN, found.isTriangle);
  @if(COAT_NORMAL) found.coatN = select(n, triangle.coatN, found.isTriangle);
  @if(MESH_STRETCH) found.tangent = select(vec3f(0.0), triangle.tangent, found.isTriangle);
  @if(MESH_STRETCH) found.bitangent = select(vec3f(0.0), triangle.bitangent, found.isTriangle);
  @if(SMOOTH) found.lift = triangle.lift;
  @if(TEXTURES && MESHES) found.uv = triangle.uv;
  @if(COLORS) found.color = select(vec4f(1.0), triangle.color, found.isTriangle);
  found.p = p;
  found.n = n;
  found.front = dot(ray.d, n) < 0.0;
  @if(BALLS) {
    // A ball is met from the side the ray starts on; at grazing angles rounding would have it otherwise now and then. Of a
    // huge one the origin's side is the less certain.
    let toOrigin = ray.o - shape.xyz;
    let startsInside = (ray.source == (hit.id | INSIDE)) | (dot(toOrigin, toOrigin) < shape.w * shape.w);
    @if(!HUGE_BALLS) found.front = select(found.front, !startsInside, isBall);
    @if(HUGE_BALLS) found.front = select(found.front, !startsInside, isBall & !isHuge);
    @if(HOLES) found.front = select(found.front, dot(ray.d, n) < 0.0, cutoffOf(found.id) != 0.0); // rays pass its near side
  }
  return found;
}

// What a ray that leaves from there names as its source: only a closed shape can be hit again, from inside.
fn sourceAt(found: SurfacePoint, hit: Hit) -> u32 {
  var source = hit.id;
  @if((BALLS || SOLIDS) && !MESHES) source |= select(INSIDE, 0u, found.front || found.shape.w == 0.0);
  @if((BALLS || SOLIDS) && MESHES) source |= select(INSIDE, 0u, found.front || found.shape.w == 0.0 || found.isTriangle);
  return source;
}

// The same of a ray that leaves from the other side.
@if(BELOW)
fn otherSourceAt(found: SurfacePoint, hit: Hit) -> u32 {
  var other = found;
  other.front = !found.front;
  return sourceAt(other, hit);
}

// The primitive of what a ray hits: of a triangle of a mesh, the mesh.
fn primitiveOf(id: u32) -> u32 {
  @if(TREE) return select(id, itemAt(id - PRIMITIVES).id, id >= PRIMITIVES);
  @if(!TREE) return id;
}
