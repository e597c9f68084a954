/** What the tracer knows about its own speed and error. */
export type Stats = {
  /** Presented frames per second, smoothed over the last second; 0 until known. */
  fps: number;
  /** Wall-clock milliseconds between two presented frames, smoothed. */
  frameMs: number;
  /** Milliseconds the GPU spent on the last frame's sampling; by timestamps where the adapter has them, else by wall clock. */
  gpuMs: number;
  /** Samples per pixel accumulated so far. */
  samples: number;
  /** Seconds of the device's work that went into these samples. */
  seconds: number;
  /** Camera paths traced per second of the device's work. */
  pathsPerSecond: number;
  /** Rays (camera, scattered and shadow rays) traced per second of the device's work. */
  raysPerSecond: number;
  /** Estimated relative RMSE of the image, `Infinity` until both halves of the film hold a sample. */
  error: number;
  /** Samples dropped because they were not finite. Anything but 0 is a bug. */
  badSamples: number;
  /** Seconds spent linking and compiling the current program. */
  compileSeconds: number;
  /** Whether `targetError` or `maxSamples` has been reached and sampling rests. */
  converged: boolean;
  /** The adapter's vendor, architecture and description, as far as it tells. */
  adapter: string;
  /** What the compiled shader contains, for example `["sphere", "plane", "ggx", "sphere light"]`. */
  features: readonly string[];
};
