// A knob for one field of a material.

import type { BladeApi, FolderApi } from "tweakpane";
import type { ResolvedMaterial, Rgb } from "../scene/schema";
import { fromHex, hueOf, strengthOf, times, toHex, withStrength } from "./colors";
import { rounded, scalesFor } from "./scales";

type FieldOf<T> = {
  [K in keyof ResolvedMaterial]-?: ResolvedMaterial[K] extends T ? K : never;
}[keyof ResolvedMaterial];

/** A row of the panel, as data. */
export type FieldKnob = {
  readonly label: string;
  /** Whether turning it changes anything, as the material stands. Left out: always. */
  readonly matters?: (material: ResolvedMaterial) => boolean;
} & (
  | { readonly kind: "slider"; readonly field: FieldOf<number>; readonly min: number; readonly max: number }
  /** A number ≥ 0 without bounds. */
  | { readonly kind: "amount"; readonly field: FieldOf<number> }
  /** The same, where 0 is shown as "none" and leaves the field out. */
  | { readonly kind: "amount or none"; readonly field: "attenuationDistance" }
  | { readonly kind: "color"; readonly field: FieldOf<Rgb> }
  /** The hue of a colour without bounds, and its strength. */
  | { readonly kind: "hue" | "strength"; readonly field: FieldOf<Rgb> }
);

/** A material whose knobs are turned. */
export type Edit = {
  readonly now: ResolvedMaterial;
  set(next: ResolvedMaterial): void;
};

// In metres. Less is none.
const LEAST_DISTANCE = 1e-9;

export function addFieldKnob(folder: FolderApi, knob: FieldKnob, edit: Edit): BladeApi {
  const { label } = knob;
  switch (knob.kind) {
    case "slider": {
      const { field, min, max } = knob;
      const shown = { value: edit.now[field] };
      // A scene may ask for more than the slider is good for.
      const range = { min: Math.min(min, shown.value), max: Math.max(max, shown.value) };
      return folder
        .addBinding(shown, "value", { label, ...range })
        .on("change", ({ value }) => edit.set({ ...edit.now, [field]: rounded(value) }));
    }
    case "amount": {
      const shown = { value: edit.now[knob.field] };
      return folder
        .addBinding(shown, "value", { label, min: 0, ...scalesFor(shown.value) })
        .on("change", ({ value }) => edit.set({ ...edit.now, [knob.field]: value }));
    }
    case "amount or none": {
      const { [knob.field]: initial = 0 } = edit.now;
      const scales = scalesFor(initial);
      const format = (value: number) => (value < LEAST_DISTANCE ? "none" : scales.format(value));
      return folder
        .addBinding({ value: initial }, "value", { label, min: 0, ...scales, format })
        .on("change", ({ value }) => {
          const { [knob.field]: _, ...without } = edit.now;
          edit.set({ ...without, ...(value >= LEAST_DISTANCE && { [knob.field]: value }) });
        });
    }
    case "color":
      return folder
        .addBinding({ value: toHex(edit.now[knob.field]) }, "value", { label, picker: "inline" })
        .on("change", ({ value }) => edit.set({ ...edit.now, [knob.field]: fromHex(value) }));
    case "hue": {
      const { field } = knob;
      return folder
        .addBinding({ value: hueOf(edit.now[field]) }, "value", { label, picker: "inline" })
        .on("change", ({ value }) =>
          edit.set({ ...edit.now, [field]: times(fromHex(value), strengthOf(edit.now[field])) }),
        );
    }
    case "strength": {
      const { field } = knob;
      const shown = { value: strengthOf(edit.now[field]) };
      let lastHue = hueOf(edit.now[field]);
      return folder
        .addBinding(shown, "value", { label, min: 0, ...scalesFor(shown.value) })
        .on("change", ({ value }) => {
          const before = edit.now[field];
          if (strengthOf(before) > 0) lastHue = hueOf(before);
          edit.set({ ...edit.now, [field]: withStrength(before, value, lastHue) });
        });
    }
  }
}
