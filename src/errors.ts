import { MAX_ISSUES } from "./scene/issueLimit";

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

/** The scene breaks the format. The message lists the issues, one per line, and counts those that are left out. */
export class SceneError extends RtViewerError {
  override readonly name = "SceneError";
  /** The first 100, in the order of the scene's fields; never empty. */
  readonly issues: readonly SceneIssue[];
  /** How many there are, those that `issues` leaves out included. */
  readonly issueCount: number;

  /** @param options.issueCount - default: as many as are given. */
  constructor(
    issues: readonly SceneIssue[],
    { issueCount = issues.length, ...options }: ErrorOptions & { readonly issueCount?: number } = {},
  ) {
    const held = issues.slice(0, MAX_ISSUES);
    const heading = `The scene has ${inDigits(issueCount)} ${issueCount === 1 ? "error" : "errors"}:`;
    super([heading, ...describeIssues(held, issueCount)].join("\n"), options);
    this.issues = held;
    this.issueCount = issueCount;
  }
}

/** A line for each issue, and one for those that are left out, if any. */
export function describeIssues(issues: readonly SceneIssue[], issueCount: number): string[] {
  const lines = issues.map(({ path, message }) => `${path || "scene"}: ${message}`);
  return issueCount > issues.length ? [...lines, `… and ${inDigits(issueCount - issues.length)} more`] : lines;
}

/** `98,765`. */
export function inDigits(count: number): string {
  return count.toLocaleString("en");
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
