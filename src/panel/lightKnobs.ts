import type { FolderApi } from "tweakpane";
import type { ResolvedLight } from "../scene/schema";
import { fromHex, hueOf, strengthOf, times, withStrength } from "./colors";
import { scalesFor } from "./scales";

/** Adds knobs for a light. */
export function addLightKnobs(folder: FolderApi, light: ResolvedLight, onChange: (light: ResolvedLight) => void): void {
  let now = light;
  const [x, y, z] = light.position;
  const shown = { color: hueOf(light.power), power: strengthOf(light.power), position: { x, y, z }, radius: 0 };
  const change = (next: ResolvedLight) => {
    now = next;
    onChange(now);
  };

  folder
    .addBinding(shown, "color", { label: "colour", picker: "inline" })
    .on("change", ({ value }) => change({ ...now, power: times(fromHex(value), shown.power) }));
  folder
    .addBinding(shown, "power", { label: "power (W)", min: 0, ...scalesFor(shown.power) })
    .on("change", ({ value }) => change({ ...now, power: withStrength(now.power, value, shown.color) }));
  if ("radius" in light) {
    shown.radius = light.radius;
    folder
      .addBinding(shown, "radius", { min: LEAST_RADIUS * light.radius, ...scalesFor(light.radius) })
      .on("change", ({ value }) => "radius" in now && change({ ...now, radius: value }));
  }
  folder
    .addBinding(shown, "position", scalesFor(1))
    .on("change", ({ value }) => change({ ...now, position: [value.x, value.y, value.z] }));
}

// Of a light's radius as it was: it needs one.
const LEAST_RADIUS = 1e-3;
