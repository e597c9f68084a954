import type { FolderApi } from "tweakpane";
import type { ResolvedLight, Rgb, Vec3 } from "../scene/schema";
import { fromHex, hueOf, strengthOf, times, withStrength } from "./colors";
import { scalesFor } from "./scales";

/** Adds knobs for a light. */
export function addLightKnobs(folder: FolderApi, light: ResolvedLight, onChange: (light: ResolvedLight) => void): void {
  let now = light as Fields;
  const change = (fields: Fields) => {
    now = { ...now, ...fields };
    onChange(now as ResolvedLight);
  };

  const strength = STRENGTHS.find(({ field }) => now[field] !== undefined)!;
  const light0 = now[strength.field]!;
  const shown = { color: hueOf(light0), strength: strengthOf(light0) };
  folder
    .addBinding(shown, "color", { label: "colour", picker: "inline" })
    .on("change", ({ value }) => change({ [strength.field]: times(fromHex(value), shown.strength) }));
  folder
    .addBinding(shown, "strength", { label: strength.label, min: 0, ...scalesFor(shown.strength) })
    .on("change", ({ value }) => {
      change({ [strength.field]: withStrength(now[strength.field]!, value, shown.color) });
    });

  const { radius, angularDiameter } = now;
  if (radius !== undefined) {
    folder
      .addBinding({ radius }, "radius", { min: LEAST_RADIUS * radius, ...scalesFor(radius) })
      .on("change", ({ value }) => change({ radius: value }));
  }
  if (angularDiameter !== undefined) {
    folder
      .addBinding({ angularDiameter }, "angularDiameter", { label: "diameter (°)", min: 0, max: 30 })
      .on("change", ({ value }) => change({ angularDiameter: value }));
  }
  const { innerAngle, outerAngle } = now;
  if (innerAngle !== undefined && outerAngle !== undefined) {
    folder
      .addBinding({ innerAngle }, "innerAngle", { label: "inner angle (°)", min: 0, max: 90 })
      .on("change", ({ value }) => change({ innerAngle: Math.min(value, LARGEST_INNER * now.outerAngle!) }));
    folder
      .addBinding({ outerAngle }, "outerAngle", { label: "outer angle (°)", min: 0.1, max: 90 })
      .on("change", ({ value }) => {
        change({ outerAngle: value, innerAngle: Math.min(now.innerAngle!, LARGEST_INNER * value) });
      });
  }
  for (const field of ["position", "direction"] as const) {
    const vector = now[field];
    if (vector === undefined) continue;
    const [x, y, z] = vector;
    folder.addBinding({ [field]: { x, y, z } }, field, scalesFor(1)).on("change", ({ value }) => {
      const { x, y, z } = value as { x: number; y: number; z: number };
      // No light has the direction 0, which dragging passes.
      if (field === "position" || Math.hypot(x, y, z) > 0) change({ [field]: [x, y, z] });
    });
  }
}

/** What one light or another has. */
type Fields = {
  readonly power?: Rgb;
  readonly irradiance?: Rgb;
  readonly intensity?: Rgb;
  readonly position?: Vec3;
  readonly direction?: Vec3;
  readonly radius?: number;
  readonly angularDiameter?: number;
  readonly innerAngle?: number;
  readonly outerAngle?: number;
};

/** How strong a light is: it has one of these. */
const STRENGTHS = [
  { field: "power", label: "power (W)" },
  { field: "irradiance", label: "irradiance (W/m²)" },
  { field: "intensity", label: "intensity (W/sr)" },
] as const;

// Of a light's radius as it was: it needs one.
const LEAST_RADIUS = 1e-3;
// Of the outer angle: the inner one is less.
const LARGEST_INNER = 0.999;
