import { create } from "webgpu";

// Dawn's null backend has no adapter of a machine behind it, but the whole of its shader compiler.
// Kept in a variable: Dawn crashes when its instance is garbage-collected while a device is in use.
const instance = create(["backend=null"]);
let device: Promise<GPUDevice> | undefined;

/** The compiler's errors and warnings, each with its line of the module: `12:5 warning: …`. Empty for a good module. */
export async function diagnose(code: string): Promise<string[]> {
  device ??= requestNullDevice();
  const opened = await device;
  opened.pushErrorScope("validation");
  const { messages } = await opened.createShaderModule({ code }).getCompilationInfo();
  await opened.popErrorScope();
  const lines = code.split("\n");
  return messages.map(({ type, lineNum, linePos, message }) => {
    return `${lineNum}:${linePos} ${type}: ${message}\n    ${lines[lineNum - 1]?.trim() ?? ""}`;
  });
}

/** What the pipeline of an entry point is refused for: bindings, workgroup size, entry point. Empty for a good one. */
export async function diagnosePipeline(code: string, entryPoint: string): Promise<string[]> {
  device ??= requestNullDevice();
  const opened = await device;
  opened.pushErrorScope("validation");
  opened.createComputePipeline({
    layout: "auto",
    compute: { module: opened.createShaderModule({ code }), entryPoint },
  });
  const error = await opened.popErrorScope();
  return error ? [error.message] : [];
}

export function releaseTint(): Promise<void> | undefined {
  return device?.then((opened) => opened.destroy());
}

async function requestNullDevice(): Promise<GPUDevice> {
  const adapter = await instance.requestAdapter();
  if (!adapter) throw new Error("Dawn's null backend has no adapter");
  return adapter.requestDevice();
}
