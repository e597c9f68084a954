import type { Scene } from "../../../src/scene/schema";
import { bumpySphere, meshObject } from "../../support/meshes";

/** One mesh of about so many triangles, lit from a side before a black sky. */
export function bumpyScene(triangles: number): Scene {
  return {
    camera: { position: [0, 0, 2] },
    materials: { white: { baseColor: [0.8, 0.8, 0.8] } },
    objects: [meshObject(bumpySphere(triangles), "white")],
    lights: [{ type: "point", position: [3, 3, 3], power: [900, 900, 900] }],
  };
}
