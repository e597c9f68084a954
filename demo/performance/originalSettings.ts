// The speed table of the student project that rt-viewer comes from: ten settings, and what its report gives for them, of
// another scene at another size.

/** How the original's author set it up for one line of his table, and what it then reported. */
export type OriginalSetting = {
  /** Per pixel and frame. */
  readonly rays: number;
  readonly bounces: number;
  /** At each hit. */
  readonly lightSamples: number;
  /** Frames per second on a GeForce GTX 970, in WebGL. */
  readonly reported: string;
};

// biome-ignore format: a table
export const ORIGINAL_SETTINGS: readonly OriginalSetting[] = [
  { rays:  5, bounces:  1, lightSamples:  1, reported: "> 60" },
  { rays: 10, bounces:  1, lightSamples:  1, reported: "> 60" },
  { rays: 15, bounces:  1, lightSamples:  1, reported: "> 60" },
  { rays: 20, bounces:  1, lightSamples:  1, reported: "> 60" },
  { rays: 10, bounces:  5, lightSamples:  1, reported: "> 60" },
  { rays: 15, bounces:  5, lightSamples:  1, reported: "30" },
  { rays: 20, bounces: 10, lightSamples:  1, reported: "27" },
  { rays: 10, bounces:  5, lightSamples:  5, reported: "30" },
  { rays: 15, bounces:  5, lightSamples: 10, reported: "20" },
  { rays: 15, bounces:  5, lightSamples: 15, reported: "14" },
];
