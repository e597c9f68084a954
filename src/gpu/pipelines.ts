import { WebGpuError } from "../errors";
import { scoped } from "./errorScope";

/**
 * Compiles one entry point without blocking.
 *
 * @param layout - `"auto"` has only the bindings that the code really uses.
 * @throws {WebGpuError} with the compiler's messages if the module is not valid, or the device's if the pipeline is not.
 */
export async function createComputePipeline(
  device: GPUDevice,
  label: string,
  code: string,
  entryPoint: string,
  layout: GPUPipelineLayout | "auto" = "auto",
): Promise<GPUComputePipeline> {
  const module = createModule(device, label, code);
  try {
    return await device.createComputePipelineAsync({ label, layout, compute: { module, entryPoint } });
  } catch (cause) {
    throw await compileError(label, module, cause);
  }
}

/** Compiles a pipeline that draws one triangle over the whole of a target of the given format, by one fragment entry point. */
export async function createBlitPipeline(
  device: GPUDevice,
  label: string,
  code: string,
  entryPoint: string,
  format: GPUTextureFormat,
): Promise<GPURenderPipeline> {
  const module = createModule(device, label, code);
  try {
    return await device.createRenderPipelineAsync({
      label,
      layout: "auto",
      vertex: { module },
      fragment: { module, entryPoint, targets: [{ format }] },
    });
  } catch (cause) {
    throw await compileError(label, module, cause);
  }
}

/** What is wrong with it, the pipeline made from it says. */
function createModule(device: GPUDevice, label: string, code: string): GPUShaderModule {
  return scoped(device, () => device.createShaderModule({ label, code })).value;
}

async function compileError(label: string, module: GPUShaderModule, cause: unknown): Promise<WebGpuError> {
  const messages = await module.getCompilationInfo().then(
    (info) => info.messages,
    () => [], // the device is lost
  );
  const errors = messages.filter(({ type }) => type === "error");
  const lines = errors.map(({ lineNum, linePos, message }) => `${label}:${lineNum}:${linePos} ${message}`);
  return new WebGpuError([`could not compile ${label}`, ...lines].join("\n"), { cause });
}
