// What a bare model is shown with: a camera that has all of it in view, and the light of a photographer's table.

import { add, cross, dot, normalize, scale, subtract } from "../math/vec3";
import { plane, sphereLight } from "../scene/builders";
import type { Camera, Environment, Light, Material, SceneObject, Vec3 } from "../scene/schema";
import type { Bounds } from "./bounds";

const VERTICAL_FOV = 35;
/** From the front right, a little above: models face +Z, by glTF's convention. */
const FROM: Vec3 = [0.5, 0.35, 1];
/** How much of the frame stays free around the model, as a factor on the distance. */
const MARGIN = 1.05;

/** Looks at the middle of the bounds from a distance at which all of them is in a square picture, so in a wider one too. */
export function frameBounds(bounds: Bounds): Camera {
  const { center, min, max } = bounds;
  const back = normalize(FROM);
  const right = normalize([back[2], 0, -back[0]]);
  const up = cross(back, right);
  const slope = Math.tan((VERTICAL_FOV * Math.PI) / 360);
  let distance = 0;
  for (let corner = 0; corner < 8; corner++) {
    const [x, y, z] = [corner & 1 ? max : min, corner & 2 ? max : min, corner & 4 ? max : min];
    const offset = subtract([x[0], y[1], z[2]], center);
    const across = Math.max(Math.abs(dot(offset, right)), Math.abs(dot(offset, up)));
    distance = Math.max(distance, dot(offset, back) + (MARGIN * across) / slope);
  }
  distance = Math.max(distance, bounds.radius); // where all is in one point
  return { position: add(center, scale(back, distance)), target: center, verticalFov: VERTICAL_FOV };
}

/** A point to look from where there is nothing to look at. */
export const IDLE_CAMERA: Camera = { position: [0, 0, 3] };

/** The parts of a scene that light a model and give it ground to stand on. */
export type Table = {
  readonly ground: SceneObject;
  readonly groundMaterial: Material;
  readonly light: Light;
  readonly environment: Environment;
};

/** Of the lamp, in the middle of the model, in W·m⁻²: white shows as white, not more, at an exposure of 0. */
export const IRRADIANCE = 3.6;
/** A scene allows no more; a model that would want it is a hundred thousand kilometres large. */
const MAX_POWER = 1e18;
/** From the upper left, in front of the model: shadows fall to the right and back. */
const LIGHT_FROM: Vec3 = [-0.7, 1.1, 0.8];
const LIGHT_COLOR: Vec3 = [1, 0.96, 0.9];

/**
 * A ground just under the model, a soft light as large as it, and light from all around that fills the shadows.
 *
 * @param groundName - the name under which the scene will have the ground's material.
 */
export function setTable(bounds: Bounds, groundName: string): Table {
  const { center, min, radius } = bounds;
  const distance = 4 * radius;
  // The gap keeps the underside of the model out of the ground; it is too small to be seen.
  const point = [center[0], min[1] - 1e-4 * radius, center[2]] as const;
  const ground = plane({ point, normal: [0, 1, 0], material: groundName });
  return {
    ground,
    groundMaterial: { baseColor: [0.55, 0.55, 0.55], roughness: 1, ior: 1 },
    light: sphereLight({
      position: add(center, scale(normalize(LIGHT_FROM), distance)),
      radius,
      power: scale(LIGHT_COLOR, Math.min(MAX_POWER, IRRADIANCE * 4 * Math.PI * distance ** 2)),
    }),
    environment: { radiance: [0.45, 0.48, 0.52] },
  };
}
