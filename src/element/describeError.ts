import { describeIssues, inDigits, SceneError, UnsupportedError, WebGpuError } from "../errors";

/** Issues that are listed in place of a picture, which has the room of about as many lines. The error holds more. */
const MAX_LISTED_ISSUES = 20;

/** What the element says in place of a picture: plain text, to be set as `textContent`. */
export type ErrorText = {
  readonly title: string;
  /** One line each. */
  readonly lines: readonly string[];
  /** Whether the lines speak to the scene's author, of paths into it. */
  readonly isCode?: boolean;
};

/** Puts an error into words for the reader of the page. */
export function describeError(error: Error): ErrorText {
  if (error instanceof SceneError) return describeSceneError(error);
  if (error instanceof UnsupportedError) return { title: "This scene cannot be shown yet", lines: [error.message] };
  if (isOutOfMemory(error)) {
    return {
      title: "The GPU is out of memory",
      lines: ["A smaller scene or a smaller picture may fit.", error.message],
    };
  }
  if (isLoss(error)) return { title: "The GPU was lost", lines: [error.message] };
  if (error instanceof WebGpuError) return { title: "No picture without WebGPU", lines: [error.message] };
  return { title: "The scene could not be loaded", lines: [error.message] };
}

/** Why this page has no WebGPU, in words that say what to do; `undefined` where it has. */
export function missingWebGpu(page: { readonly hasGpu: boolean; readonly isSecure: boolean }): string | undefined {
  if (page.hasGpu) return undefined;
  if (!page.isSecure) return "WebGPU needs a secure page: serve it over https, or from localhost.";
  return "This browser has no WebGPU. Recent versions of Chrome, Edge, Safari and Firefox do; it may need to be enabled.";
}

function isOutOfMemory({ cause }: Error): boolean {
  return "GPUOutOfMemoryError" in globalThis && cause instanceof GPUOutOfMemoryError;
}

function isLoss({ cause }: Error): boolean {
  return "GPUDeviceLostInfo" in globalThis && cause instanceof GPUDeviceLostInfo;
}

function describeSceneError({ issues, issueCount }: SceneError): ErrorText {
  return {
    title: issueCount === 1 ? "The scene has a mistake" : `The scene has ${inDigits(issueCount)} mistakes`,
    lines: describeIssues(issues.slice(0, MAX_LISTED_ISSUES), issueCount),
    isCode: true,
  };
}
