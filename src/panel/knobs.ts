import type { FolderApi } from "tweakpane";
import type { Settings } from "../renderer/settings";

/** The settings that the panel lets one turn. */
export type PanelKnobs = Pick<
  Settings,
  "samplesPerFrame" | "lightSamples" | "estimator" | "sampler" | "targetError"
> & {
  readonly maxBounces: number;
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
  maxBounces: { label: "bounces", min: 0, max: 16, step: 1 },
  lightSamples: { label: "light samples", min: 1, max: 15, step: 1 },
  exposure: { label: "exposure", min: -6, max: 6, step: 0.1 },
} as const;

const MOST_FRAME_SAMPLES = 20;

const CHOICES = {
  estimator: { label: "estimator", options: { "path tracing": "path", uniform: "uniform" } },
  sampler: { label: "sampler", options: { Sobol: "sobol", independent: "independent" } },
} as const;

/** Adds the folder with the knobs. `set` shows values that were changed elsewhere without calling `onChange`. */
export function addKnobs(pane: FolderApi, options: KnobOptions): { set(values: Partial<PanelKnobs>): void } {
  const folder = pane.addFolder({ title: "Settings" });
  const values = { ...options.knobs, ...asNumbers(options.knobs) };
  let isBeingSet = false;
  const change = (changes: Partial<PanelKnobs>) => {
    if (!isBeingSet) options.onChange(changes);
  };

  const samples = folder
    .addBinding(values, "frameSamples", {
      label: "samples/frame",
      min: 0,
      max: Math.max(MOST_FRAME_SAMPLES, values.frameSamples),
      step: 1,
      format: (count) => (count === 0 ? "auto" : String(count)),
    })
    .on("change", ({ value }) => change({ samplesPerFrame: value === 0 ? "auto" : value }));
  const sliders = (Object.keys(SLIDERS) as (keyof typeof SLIDERS)[]).map((name) => {
    const { label, min, max, step } = SLIDERS[name];
    // A scene may ask for more than the slider is good for.
    const binding = folder.addBinding(values, name, { label, step, min, max: Math.max(max, values[name]) });
    return binding.on("change", ({ value }) => change({ [name]: value }));
  });
  const choices = (Object.keys(CHOICES) as (keyof typeof CHOICES)[]).map((name) => {
    const binding = folder.addBinding(values, name, CHOICES[name]);
    return binding.on("change", ({ value }) => change({ [name]: value }));
  });
  const target = folder
    .addBinding(values, "targetPercent", {
      label: "stop at % error",
      min: 0,
      keyScale: 0.1,
      pointerScale: 0.01,
      format: (percent) => (percent === 0 ? "never" : String(Number(percent.toPrecision(3)))),
    })
    .on("change", ({ value }) => change({ targetError: value / 100 }));
  folder.addButton({ title: "Start over" }).on("click", options.onReset);

  return {
    set(changes) {
      Object.assign(values, changes);
      Object.assign(values, asNumbers(values));
      isBeingSet = true;
      for (const binding of [samples, ...sliders, ...choices, target]) binding.refresh();
      isBeingSet = false;
    },
  };
}

/** What is shown as other numbers: 0 samples per frame are `"auto"`, and errors are per cents. */
function asNumbers({ samplesPerFrame, targetError }: PanelKnobs): { frameSamples: number; targetPercent: number } {
  return { frameSamples: samplesPerFrame === "auto" ? 0 : samplesPerFrame, targetPercent: 100 * targetError };
}
