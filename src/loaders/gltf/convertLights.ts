import { length, scale, subtract } from "../../math/vec3";
import { pointLight } from "../../scene/builders";
import type { Light } from "../../scene/schema";
import type { Bounds } from "../bounds";
import type { Warnings } from "../warnings";
import { placeOf } from "./materials";
import { type PlacedNode, positionOf } from "./nodes";
import type { GltfJson } from "./schema";

/**
 * The point lights. Photometric units are taken one to one, as other viewers do: 1 cd is 1 W·sr⁻¹. So lights and emissive
 * surfaces keep their proportions.
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
    } = json.extensions!.KHR_lights_punctual!.lights[index]!;
    const place = placeOf("lights", index, name);
    if (type !== "point") {
      warnings.add(`Lights of type ${type} are not supported, and left out`, place);
      continue;
    }
    if (range !== undefined) warnings.add("The range of a light is not supported: it shines on", place);
    lights.push(pointLight({ position: positionOf(world), power: scale(color, 4 * Math.PI * intensity) }));
  }
  return lights;
}

/** A white surface that gets more irradiance, W·m⁻², shows as nothing but white at an exposure of 0. */
const BLINDING_IRRADIANCE = 100;
/** With which it shows as white and no more. */
const GOOD_IRRADIANCE = 4;

/** Exporters that count lumens write numbers 683 times as large as those that count watts. That can't be told from the file. */
export function warnOfBrightness(lights: readonly Light[], bounds: Bounds, warnings: Warnings): void {
  if (bounds.isEmpty) return;
  let irradiance = 0;
  for (const { position, power } of lights) {
    const distance = Math.max(bounds.radius, length(subtract(position, bounds.center)));
    irradiance += Math.max(...power) / (4 * Math.PI * distance ** 2);
  }
  if (irradiance <= BLINDING_IRRADIANCE) return;
  const stops = Math.round(Math.log2(irradiance / GOOD_IRRADIANCE));
  warnings.add(`The lights are about ${stops} stops too bright for an exposure of 0; try one of -${stops}`);
}
