import type { Scene } from "../../src/scene/schema";

export type MeasureOptions = {
  /** In pixels. */
  readonly width: number;
  readonly height: number;
  /** Samples per pixel, ascending: an image for each. */
  readonly samples: readonly number[];
  readonly seed: number;
};

export type TimedImage = {
  /** Per pixel, as many as were taken. */
  readonly samples: number;
  /** From an empty image to this one, without compilation. */
  readonly seconds: number;
  /** RGB, linear Rec. 709, top row first. */
  readonly radiance: Float32Array;
};

/** One renderer's images of one scene. */
export type Measurement = {
  /** Name and version. */
  readonly renderer: string;
  /** What it ran on. */
  readonly adapter: string;
  /** Reading and compiling the scene, until the first sample can be taken. */
  readonly setupSeconds: number;
  readonly images: readonly TimedImage[];
};

/** What a renderer that runs in a page exports. */
export type Measure = (scene: Scene, options: MeasureOptions) => Promise<Measurement>;

/** The three ways in which rt-viewer itself takes part. */
export const VARIANTS = ["ours", "independent", "uniform"] as const;
export type Variant = (typeof VARIANTS)[number];

export type EstimateOptions = Pick<MeasureOptions, "width" | "height" | "samples" | "seed"> & {
  readonly sampler: "sobol" | "independent";
};

/** What the viewer thinks of its image, beside the image. */
export type EstimatedImage = {
  readonly samples: number;
  /** `stats.error`. */
  readonly estimate: number;
  readonly radiance: Float32Array;
};

/** Frames that each show a new image of `rays` samples per pixel. */
export type FrameOptions = {
  readonly width: number;
  readonly height: number;
  readonly estimator: "path" | "uniform";
  readonly rays: number;
  readonly bounces: number;
  readonly lightSamples: number;
  /** How many are timed, after two that are not. */
  readonly frames: number;
};

export type MeasuredFrames = {
  readonly adapter: string;
  /** Of each frame. */
  readonly seconds: readonly number[];
  /** Two images of different seeds. */
  readonly images: readonly [Float32Array, Float32Array];
};

/** Where rt-viewer runs: a page, or Node. */
export type Host = {
  readonly name: "Chromium" | "Dawn in Node";
  measure(variant: Variant, scene: Scene, options: MeasureOptions): Promise<Measurement>;
  estimates(scene: Scene, options: EstimateOptions): Promise<EstimatedImage[]>;
  frames(scene: Scene, options: FrameOptions): Promise<MeasuredFrames>;
};
