import type { FolderApi } from "tweakpane";
import type { ResolvedLight, ResolvedMaterial } from "../scene/schema";
import { fromHex, hueOf, strengthOf, times, toHex, withStrength } from "./colors";

// Of a value without bounds: what a pixel of dragging and an arrow key add, as a share of it.
const DRAG_SHARE = 0.01;
const KEY_SHARE = 0.05;

/** Adds knobs for a material; those that would change nothing as it stands are hidden. */
export function addMaterialKnobs(
  folder: FolderApi,
  material: ResolvedMaterial,
  onChange: (material: ResolvedMaterial) => void,
): void {
  let now = material;
  const { metallic, roughness, ior, masking, multiscatter, emission } = material;
  const shown = {
    ...{ color: toHex(material.baseColor), metallic, roughness, ior, masking, multiscatter },
    ...{ glow: hueOf(emission), radiance: strengthOf(emission) },
  };
  const change = (changes: Partial<ResolvedMaterial>) => {
    now = { ...now, ...changes };
    hideUseless();
    onChange(now);
  };

  folder
    .addBinding(shown, "color", { label: "colour", picker: "inline" })
    .on("change", ({ value }) => change({ baseColor: fromHex(value) }));
  folder
    .addBinding(shown, "metallic", { min: 0, max: 1 })
    .on("change", ({ value }) => change({ metallic: rounded(value) }));
  folder
    .addBinding(shown, "roughness", { min: 0, max: 1 })
    .on("change", ({ value }) => change({ roughness: rounded(value) }));
  const iorKnob = folder
    .addBinding(shown, "ior", { label: "ior", min: 1, max: Math.max(3, ior) })
    .on("change", ({ value }) => change({ ior: rounded(value) }));
  const maskingKnob = folder
    .addBinding(shown, "masking", { options: { Smith: "smith", "Schlick–Beckmann": "schlick-beckmann" } })
    // Multiple scattering is known for Smith's masking only.
    .on("change", ({ value }) => change({ masking: value, ...(value !== "smith" && { multiscatter: false }) }));
  const multiscatterKnob = folder
    .addBinding(shown, "multiscatter")
    .on("change", ({ value }) => change({ multiscatter: value }));
  const glowKnob = folder
    .addBinding(shown, "glow", { label: "emission", picker: "inline" })
    .on("change", ({ value }) => change({ emission: times(fromHex(value), shown.radiance) }));
  folder
    .addBinding(shown, "radiance", { label: "radiance", min: 0, ...scalesFor(shown.radiance) })
    .on("change", ({ value }) => change({ emission: withStrength(now.emission, value, shown.glow) }));

  const hideUseless = () => {
    const hasLobe = now.metallic > 0 || now.ior > 1;
    iorKnob.hidden = now.metallic === 1;
    maskingKnob.hidden = !hasLobe || now.roughness === 0;
    multiscatterKnob.hidden = maskingKnob.hidden || now.metallic === 0 || now.masking !== "smith";
    glowKnob.hidden = strengthOf(now.emission) === 0;
    shown.multiscatter = now.multiscatter;
    multiscatterKnob.refresh();
  };
  hideUseless();
}

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

function scalesFor(value: number) {
  const size = value > 0 ? value : 1;
  return { pointerScale: DRAG_SHARE * size, keyScale: KEY_SHARE * size, format: formatShort };
}

/** To thousandths. Tweakpane's own steps are counted from the first value, and miss 0 and 1 by a rounding error. */
function rounded(value: number): number {
  return Math.round(1000 * value) / 1000;
}

/** Four digits: as many as fit. */
function formatShort(value: number): string {
  return String(Number(value.toPrecision(4)));
}
