import { accessSync, constants, existsSync, realpathSync } from "node:fs";
import { createRequire } from "node:module";
import { delimiter, dirname, join } from "node:path";

const NAMES = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"];
// Where distributions put the browser itself when the command on the PATH is a script.
const DIRECTORIES = ["/usr/lib/chromium", "/usr/lib/chromium-browser", "/opt/google/chrome", "/usr/lib64/chromium"];

type Environment = Readonly<Record<string, string | undefined>>;

/**
 * Where a Chromium may be, best first: `RT_VIEWER_CHROMIUM`, `CHROME_PATH`, the usual names on the `PATH`, Playwright's own.
 *
 * @param playwrightPath - what Playwright's `executablePath()` says, whether or not a file is there.
 */
export function chromiumCandidates(environment: Environment, playwrightPath?: string): readonly string[] {
  const folders = (environment.PATH ?? "").split(delimiter).filter((folder) => folder !== "");
  const onPath = NAMES.flatMap((name) => folders.map((folder) => join(folder, name)));
  return [environment.RT_VIEWER_CHROMIUM, environment.CHROME_PATH, ...onPath, playwrightPath].filter(
    (path): path is string => path !== undefined && path !== "",
  );
}

/** The command that starts an installed Chromium, or `undefined` if there is none. */
export function findChromium(environment: Environment = process.env): string | undefined {
  return installed(environment)[0];
}

/**
 * The Vulkan manifest of the software adapter (SwiftShader) that comes with Chromium: the value of `VK_ICD_FILENAMES` with
 * which Dawn in Node finds it.
 */
export function softwareAdapterManifest(environment: Environment = process.env): string | undefined {
  const beside = installed(environment).map((path) => dirname(realpathSync(path)));
  return [...beside, ...DIRECTORIES].map((folder) => join(folder, "vk_swiftshader_icd.json")).find(existsSync);
}

function installed(environment: Environment): readonly string[] {
  return chromiumCandidates(environment, playwrightChromium()).filter(isExecutable);
}

function isExecutable(path: string): boolean {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

function playwrightChromium(): string | undefined {
  try {
    // Loaded when asked for: `@playwright/test` would install its own `expect` into whatever test runner imports this.
    const { chromium } = createRequire(import.meta.url)("playwright-core") as typeof import("playwright-core");
    return chromium.executablePath();
  } catch {
    return undefined; // not installed
  }
}
