/** Base of every error this package throws on purpose: `error instanceof RtViewerError` tells ours from a bug. */
export class RtViewerError extends Error {
  override readonly name: string = "RtViewerError";
}

/** One thing that is wrong with a scene. */
export type SceneIssue = {
  /** Where, as one would write it in JavaScript: `objects[3].radius`; `""` is the scene itself. */
  readonly path: string;
  /** What was expected and what was found, in one line. */
  readonly message: string;
};

/** The scene breaks the format. Holds every issue; the message lists them, one per line. */
export class SceneError extends RtViewerError {
  override readonly name = "SceneError";
  /** In the order of the scene's fields; never empty. */
  readonly issues: readonly SceneIssue[];

  constructor(issues: readonly SceneIssue[], options?: ErrorOptions) {
    const heading = `The scene has ${issues.length} ${issues.length === 1 ? "error" : "errors"}:`;
    super([heading, ...issues.map(({ path, message }) => `${path || "scene"}: ${message}`)].join("\n"), options);
    this.issues = issues;
  }
}

/** There is no WebGPU or no adapter, the device is lost, or a shader does not compile. The original error is the `cause`. */
export class WebGpuError extends RtViewerError {
  override readonly name = "WebGpuError";
}

/** The scene is valid, but this version cannot render something in it. */
export class UnsupportedError extends RtViewerError {
  override readonly name = "UnsupportedError";
}

/** A file cannot be made into a scene: it is damaged, needs something we lack, or is too large. The message starts with its name. */
export class LoadError extends RtViewerError {
  override readonly name = "LoadError";
}
