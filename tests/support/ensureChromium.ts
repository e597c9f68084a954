import { spawnSync } from "node:child_process";
import { findChromium, softwareAdapterManifest } from "../../src/cli/chromium";

type Attempt = readonly [command: string, ...args: string[]];

/** Installs a Chromium for the tests where the machine has none, or says exactly what to install and exits 1. */
export function main(): void {
  if (isReady()) return;
  for (const attempt of attempts(process.getuid?.() === 0)) {
    const [command, ...args] = attempt;
    console.log(`No Chromium with a software WebGPU adapter found; trying: ${attempt.join(" ")}`);
    spawnSync(command, args, { stdio: "inherit", env: { ...process.env, DEBIAN_FRONTEND: "noninteractive" } });
    if (isReady()) return;
  }
  console.error(
    [
      "The tests need a Chromium (with its software GPU driver, vk_swiftshader_icd.json, beside it). Install one with",
      "    sudo apt-get install chromium                       (Debian)",
      "    npx playwright install --with-deps chromium         (elsewhere)",
      "or name an installed one: RT_VIEWER_CHROMIUM=/path/to/chrome npm test",
    ].join("\n"),
  );
  process.exitCode = 1;
}

function isReady(): boolean {
  // Dawn in Node needs the software adapter on Linux only; elsewhere it has the system's own.
  return findChromium() !== undefined && (process.platform !== "linux" || softwareAdapterManifest() !== undefined);
}

/** Playwright's download first: it needs no root for itself and does not change the system. */
function attempts(isRoot: boolean): readonly Attempt[] {
  if (!isRoot) return [["npx", "playwright", "install", "chromium"]];
  return [
    ["npx", "playwright", "install", "--with-deps", "chromium"],
    ["apt-get", "update"],
    ["apt-get", "install", "--yes", "chromium"],
  ];
}
