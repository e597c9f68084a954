import { add, cross, length, normalize, scale, subtract } from "../../math/vec3";
import { directionalLight, pointLight, spotLight } from "../../scene/builders";
import type { Light, Vec3 } from "../../scene/schema";
import type { Bounds } from "../bounds";
import { lightAt } from "../lightAt";
import type { Warnings } from "../warnings";
import { placeOf } from "./materials";
import { axisOf, type PlacedNode, positionOf } from "./nodes";
import type { GltfJson } from "./schema";

type GltfLight = NonNullable<NonNullable<GltfJson["extensions"]>["KHR_lights_punctual"]>["lights"][number];

/**
 * The lights. Photometric units are taken one to one, as other viewers do: 1 cd is 1 W·sr⁻¹ and 1 lx is 1 W·m⁻². So lights and
 * emissive surfaces keep their proportions.
 */
export function convertLights(json: GltfJson, nodes: readonly PlacedNode[], warnings: Warnings): Light[] {
  const lights: Light[] = [];
  for (const { node, world } of nodes) {
    const index = node.extensions?.KHR_lights_punctual?.light;
    if (index === undefined) continue;
    const {
      type,
      name,
      color = [1, 1, 1],
      intensity = 1,
      range,
      spot = {},
    } = json.extensions!.KHR_lights_punctual!.lights[index]!;
    const place = placeOf("lights", index, name);
    const direction = type === "point" ? undefined : backwardOf(world);
    if (type !== "point" && !direction) {
      warnings.add("A light in a space without size has no direction, and is left out", place);
      continue;
    }
    if (type === "directional") {
      lights.push(directionalLight({ direction: direction!, irradiance: scale(color, intensity) }));
      continue;
    }
    if (range !== undefined) warnings.add("The range of a light is not supported: it shines on", place);
    const position = positionOf(world);
    if (type === "point") lights.push(pointLight({ position, power: scale(color, 4 * Math.PI * intensity) }));
    else
      lights.push(
        spotLight({ position, direction: direction!, intensity: scale(color, intensity), ...anglesOf(spot) }),
      );
  }
  return lights;
}

/** In degrees, brought into order where a file's are not. */
function anglesOf({ innerConeAngle = 0, outerConeAngle = Math.PI / 4 }: NonNullable<GltfLight["spot"]>) {
  const outerAngle = Math.min(Math.max(outerConeAngle * DEGREES, 1e-3), 90);
  return { innerAngle: Math.min(Math.max(innerConeAngle * DEGREES, 0), LARGEST_INNER * outerAngle), outerAngle };
}

const DEGREES = 180 / Math.PI;
// Of the outer angle: a file may have both alike.
const LARGEST_INNER = 0.999;

/** Where the −z of a space points in the world, unit; undefined in one that is flattened to a line or a point. */
function backwardOf(world: Float64Array): Vec3 | undefined {
  const [x, y, z] = [axisOf(world, 0), axisOf(world, 1), axisOf(world, 2)];
  const axis = length(z) > 0 ? z : cross(x, y);
  return length(axis) > 0 ? scale(normalize(axis), -1) : undefined;
}

/** A white surface that gets more irradiance, W·m⁻², shows as nothing but white at an exposure of 0. */
const BLINDING_IRRADIANCE = 100;
/** With which it shows as white and no more. */
const GOOD_IRRADIANCE = 4;

/** The middle of a model, or, of a light that is nearer to it, the point as far from the light as the model's edge is from the middle. */
function nearest({ center, radius }: Bounds, light: Light): Vec3 {
  if (!("position" in light)) return center;
  const way = subtract(center, light.position);
  const distance = length(way);
  if (distance >= radius) return center;
  return add(light.position, distance > 0 ? scale(way, radius / distance) : [radius, 0, 0]);
}

/** Exporters that count lumens write numbers 683 times as large as those that count watts. That can't be told from the file. */
export function warnOfBrightness(lights: readonly Light[], bounds: Bounds, warnings: Warnings): void {
  if (bounds.isEmpty) return;
  let irradiance = 0;
  for (const light of lights) irradiance += Math.max(...lightAt(light, nearest(bounds, light)).irradiance);
  if (irradiance <= BLINDING_IRRADIANCE) return;
  const stops = Math.round(Math.log2(irradiance / GOOD_IRRADIANCE));
  warnings.add(`The lights are about ${stops} stops too bright for an exposure of 0; try one of -${stops}`);
}
