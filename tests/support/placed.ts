import type { Scene, SceneObject, Vec3 } from "../../src/scene/schema";
import { add, scale } from "./oracle";

/** The same scene at another size and place: lengths times `size`, then moved by `by`. Emission is radiance and stays. */
export function placed(scene: Scene, size: number, by: Vec3): Scene {
  const at = (point: Vec3): Vec3 => add(scale(point, size), by);
  const { camera } = scene;
  if (scene.lights?.length) throw new RangeError("lights by power are not scaled");
  return {
    ...scene,
    camera: { ...camera, position: at(camera.position), target: at(camera.target ?? [0, 0, 0]) },
    objects: (scene.objects ?? []).map((object) => placedObject(object, size, at)),
  };
}

function placedObject(object: SceneObject, size: number, at: (point: Vec3) => Vec3): SceneObject {
  switch (object.type) {
    case "sphere":
      return { ...object, center: at(object.center), radius: size * object.radius };
    case "plane":
      return { ...object, point: at(object.point) };
    case "quad":
      return {
        ...object,
        corner: at(object.corner),
        edge1: scale(object.edge1, size),
        edge2: scale(object.edge2, size),
      };
    case "triangle": {
      const [a, b, c] = object.vertices;
      return { ...object, vertices: [at(a), at(b), at(c)] };
    }
    case "box":
      return { ...object, center: at(object.center), size: scale(object.size, size) };
    case "mesh":
      throw new RangeError("meshes are not placed yet");
  }
}
