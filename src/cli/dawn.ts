import { constants } from "node:os";
import { dirname, join } from "node:path";
import { create } from "webgpu";
import { openDevice } from "../gpu/device";
import { softwareAdapterManifest } from "./chromium";

// dlopen's flag that keeps a library loaded although Node refuses it as an addon (Linux, dlfcn.h).
const RTLD_NODELETE = 0x1000;

// Dawn crashes when its instance is garbage-collected while a device is in use.
let instance: GPU | undefined;

/**
 * A device of Dawn, WebGPU for Node: on the system's own driver where Dawn accepts one, else on the software adapter that
 * comes with Chromium.
 *
 * @throws {WebGpuError} if there is neither.
 */
export async function requestDawnDevice(): Promise<GPUDevice> {
  const hasLoader = process.platform !== "linux" || loadLibrary("libvulkan.so.1");
  if (!(hasLoader && (await create([]).requestAdapter()))) {
    const manifest = softwareAdapterManifest();
    if (manifest) {
      process.env.VK_ICD_FILENAMES = manifest;
      loadLibrary(join(dirname(manifest), "libvulkan.so.1"));
    }
  }
  instance = create([]);
  return openDevice(instance);
}

/** Loads a shared library for good, so that Dawn's own dlopen finds it by name; false if there is none. */
function loadLibrary(name: string): boolean {
  try {
    process.dlopen({ exports: {} }, name, constants.dlopen.RTLD_NOW | RTLD_NODELETE);
    return true;
  } catch (error) {
    return (error as Error).message.includes("did not self-register"); // loaded, though it is no addon
  }
}
