import { add, cross, dot, length, normalize, scale, subtract } from "../../math/vec3";
import type { Camera, Vec3 } from "../../scene/schema";
import type { Bounds } from "../bounds";
import type { Warnings } from "../warnings";
import { placeOf } from "./materials";
import { axisOf, type PlacedNode, positionOf } from "./nodes";
import type { GltfJson } from "./schema";

const DEGREES = 180 / Math.PI;

/** The sine of an angle that is not seen, and that is still far from where the directions of a camera are all rounding. */
const SMALL_SINE = 1e-3;

/**
 * The first camera of the scene; `undefined` if there is none that ours can stand for.
 *
 * @param bounds - of the meshes: the camera is turned around a point in their middle.
 */
export function convertCamera(
  json: GltfJson,
  nodes: readonly PlacedNode[],
  bounds: Bounds,
  warnings: Warnings,
): Camera | undefined {
  for (const { node, world } of nodes) {
    if (node.camera === undefined) continue;
    const { name, ...camera } = json.cameras[node.camera]!;
    const place = placeOf("cameras", node.camera, name);
    const [right, up, back] = [axisOf(world, 0), axisOf(world, 1), axisOf(world, 2)];
    const lens = lensOf(camera);
    if (lens === undefined) {
      warnings.add("A camera without a field of view is left out: the model is framed instead", place);
    } else if (!(length(cross(up, back)) > SMALL_SINE * length(up) * length(back))) {
      warnings.add("A camera flattened by its node's scale is left out: the model is framed instead", place);
    } else {
      const ahead = normalize(scale(back, -1));
      const position = startOf(positionOf(world), ahead, camera, bounds);
      const target = add(position, scale(ahead, depthOf(bounds, position, ahead)));
      return {
        position,
        target,
        up: isLevel(right, up, ahead) ? [0, 1, 0] : up,
        ...lens,
      };
    }
  }
  return undefined;
}

type GltfCamera = GltfJson["cameras"][number];

/** What the scale of the camera's node has no part in, by glTF's rule. `undefined` for a picture of no size. */
function lensOf({ type, perspective, orthographic }: GltfCamera): Partial<Camera> | undefined {
  if (type === "perspective") return perspective && { verticalFov: perspective.yfov * DEGREES };
  return orthographic?.ymag ? { orthographicHeight: 2 * Math.abs(orthographic.ymag) } : undefined;
}

/** The rays of an orthographic camera start at its near plane, if that cuts something off. Those of others start at the node. */
function startOf(position: Vec3, ahead: Vec3, { type, orthographic }: GltfCamera, bounds: Bounds): Vec3 {
  if (type === "perspective" || !orthographic || bounds.isEmpty) return position;
  const { min, max } = bounds;
  const depths = position.map((at, axis) =>
    Math.min((min[axis]! - at) * ahead[axis]!, (max[axis]! - at) * ahead[axis]!),
  );
  const nearest = depths.reduce((sum, depth) => sum + depth);
  const { znear } = orthographic;
  return nearest < Math.max(znear, 0) ? add(position, scale(ahead, znear)) : position;
}

/** Whether the horizon is level in the picture: then the camera is to be turned around the vertical, though it looks down. */
function isLevel(right: Vec3, up: Vec3, ahead: Vec3): boolean {
  const isSteep = Math.hypot(ahead[0], ahead[2]) < SMALL_SINE;
  return !isSteep && up[1] > 0 && Math.abs(right[1]) <= SMALL_SINE * length(right);
}

/** How far ahead the middle of the meshes is; something sensible where it is behind, or nowhere. */
function depthOf(bounds: Bounds, position: Vec3, ahead: Vec3): number {
  if (bounds.isEmpty) return 1;
  const depth = dot(subtract(bounds.center, position), ahead);
  return depth > bounds.radius / 100 ? depth : bounds.radius;
}
