import type { FolderApi } from "tweakpane";

/** The settings that the panel lets one turn. */
export type PanelKnobs = {
  /** Samples per pixel between two frames. */
  readonly samplesPerFrame: number;
  readonly maxBounces: number;
  /** Light points sampled at each hit. */
  readonly lightSamples: number;
  /** Stops. */
  readonly exposure: number;
};

type KnobOptions = {
  readonly knobs: PanelKnobs;
  readonly onChange: (changes: Partial<PanelKnobs>) => void;
  readonly onReset: () => void;
};

/** The range of each slider: what is useful to turn by hand, not all that is allowed. */
const SLIDERS = {
  samplesPerFrame: { label: "samples/frame", min: 1, max: 20, step: 1 },
  maxBounces: { label: "bounces", min: 0, max: 16, step: 1 },
  lightSamples: { label: "light samples", min: 1, max: 15, step: 1 },
  exposure: { label: "exposure", min: -6, max: 6, step: 0.1 },
} as const;

/** Adds the folder with the knobs. `set` shows values that were changed elsewhere without calling `onChange`. */
export function addKnobs(pane: FolderApi, options: KnobOptions): { set(values: Partial<PanelKnobs>): void } {
  const folder = pane.addFolder({ title: "Settings" });
  const values = { ...options.knobs };
  let isBeingSet = false;

  const names = Object.keys(SLIDERS) as (keyof PanelKnobs)[];
  const bindings = names.map((name) => {
    const { label, min, max, step } = SLIDERS[name];
    // A scene may ask for more than the slider is good for.
    const binding = folder.addBinding(values, name, { label, step, min, max: Math.max(max, values[name]) });
    binding.on("change", ({ value }) => {
      if (!isBeingSet) options.onChange({ [name]: value });
    });
    return binding;
  });
  folder.addButton({ title: "Start over" }).on("click", options.onReset);

  return {
    set(changes) {
      Object.assign(values, changes);
      isBeingSet = true;
      for (const binding of bindings) binding.refresh();
      isBeingSet = false;
    },
  };
}
