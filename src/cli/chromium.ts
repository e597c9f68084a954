import { existsSync, realpathSync } from "node:fs";
import { delimiter, dirname, join } from "node:path";

const NAMES = ["chromium", "chromium-browser", "google-chrome", "chrome"];
// Where distributions put the browser itself when the command on the PATH is a script.
const DIRECTORIES = ["/usr/lib/chromium", "/usr/lib/chromium-browser", "/opt/google/chrome", "/usr/lib64/chromium"];

/** The command that starts an installed Chromium: `RT_VIEWER_CHROMIUM`, or the first on the PATH. */
export function findChromium(): string | undefined {
  const chosen = process.env.RT_VIEWER_CHROMIUM;
  if (chosen) return chosen;
  const folders = (process.env.PATH ?? "").split(delimiter).filter((folder) => folder !== "");
  return folders.flatMap((folder) => NAMES.map((name) => join(folder, name))).find((path) => existsSync(path));
}

/** The Vulkan manifest of the software adapter (SwiftShader) beside an installed Chromium. */
export function softwareAdapterManifest(chromium = findChromium()): string | undefined {
  const beside = chromium && existsSync(chromium) ? [dirname(realpathSync(chromium))] : [];
  return [...beside, ...DIRECTORIES].map((folder) => join(folder, "vk_swiftshader_icd.json")).find(existsSync);
}
