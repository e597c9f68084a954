import { requestDawnDevice } from "../../src/cli/dawn";
import type { Host } from "./measurement";
import { measureEstimates, measureFrames, measureOurs } from "./ours";

/** rt-viewer in this process, on one device. */
export async function openDawn(): Promise<Host> {
  const device = await requestDawnDevice();
  return {
    name: "Dawn in Node",
    measure: (variant, scene, options) => measureOurs(variant, scene, options, device),
    estimates: (scene, options) => measureEstimates(scene, options, device),
    frames: (scene, options) => measureFrames(scene, options, device),
  };
}
