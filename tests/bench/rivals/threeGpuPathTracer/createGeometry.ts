import { BoxGeometry, BufferGeometry, Float32BufferAttribute, SphereGeometry, Vector3 } from "three";
import type { ResolvedObject, Vec3 } from "../../../../src/scene/schema";

// Half the edge of the square in place of an infinite plane, metres.
const PLANE_EXTENT = 1e4;
// Around the equator: off by 3e-4 of the radius, a hundredth of a pixel.
const SPHERE_SEGMENTS = 128;

/** The triangles of an object, in world space. */
export function createGeometry(object: ResolvedObject): BufferGeometry {
  switch (object.type) {
    case "sphere":
      return createSphere(object.center, object.radius);
    case "plane":
      return createSquare(new Vector3(...object.point), new Vector3(...object.normal).normalize());
    case "quad":
      return createQuad(new Vector3(...object.corner), new Vector3(...object.edge1), new Vector3(...object.edge2));
    case "triangle":
      return createFaceted(object.vertices.flat(), [0, 1, 2]);
    case "box":
      return new BoxGeometry(...object.size).rotateY((object.rotationY * Math.PI) / 180).translate(...object.center);
    case "mesh": {
      if (object.normals === undefined) return createFaceted([...object.positions], [...object.indices]);
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new Float32BufferAttribute(object.positions, 3));
      geometry.setAttribute("normal", new Float32BufferAttribute(object.normals, 3));
      return geometry.setIndex([...object.indices]);
    }
  }
}

export function createSphere(center: Vec3, radius: number): BufferGeometry {
  return new SphereGeometry(radius, SPHERE_SEGMENTS, SPHERE_SEGMENTS / 2).translate(...center);
}

function createSquare(center: Vector3, normal: Vector3): BufferGeometry {
  const u = new Vector3(1, 0, 0);
  if (Math.abs(normal.x) > 0.9) u.set(0, 1, 0);
  u.cross(normal).setLength(PLANE_EXTENT);
  const v = normal.clone().cross(u);
  return createQuad(center.clone().sub(u).sub(v), u.multiplyScalar(2), v.multiplyScalar(2));
}

function createQuad(corner: Vector3, edge1: Vector3, edge2: Vector3): BufferGeometry {
  const corners = [corner, corner.clone().add(edge1), corner.clone().add(edge1).add(edge2), corner.clone().add(edge2)];
  return createFaceted(
    corners.flatMap((point) => point.toArray()),
    [0, 1, 2, 0, 2, 3],
  );
}

function createFaceted(positions: readonly number[], indices: readonly number[]): BufferGeometry {
  const geometry = new BufferGeometry();
  const vertices = indices.flatMap((i) => positions.slice(3 * i, 3 * i + 3));
  geometry.setAttribute("position", new Float32BufferAttribute(vertices, 3));
  geometry.setIndex(indices.map((_, i) => i));
  geometry.computeVertexNormals();
  return geometry;
}
