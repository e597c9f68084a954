import { defineConfig } from "@playwright/test";
import { findChromium } from "./src/cli/chromium";
import { DEMO_URL, FIXTURE_URL } from "./tests/e2e/support/urls";
import { SOFTWARE_WEBGPU_FLAGS } from "./tests/support/chromium";

const executablePath = findChromium();
if (executablePath === undefined) {
  throw new Error(
    "No Chromium found. Install one (apt-get install chromium, or npx playwright install --with-deps chromium), " +
      "or name one in RT_VIEWER_CHROMIUM.",
  );
}

const serve = (config: string, url: string) => ({
  command: `npx vite build --config ${config} && npx vite preview --config ${config} --port ${new URL(url).port} --strictPort`,
  url,
  reuseExistingServer: process.env.CI === undefined,
});

/**
 * The element, the demo and the packed package, as last built, in a real browser, on its software adapter. One test at a time:
 * each wants the whole CPU.
 */
export default defineConfig({
  projects: [
    { name: "e2e", testDir: "tests/e2e" },
    { name: "package", testDir: "tests/package" },
  ],
  outputDir: "tests/output/playwright",
  workers: 1,
  timeout: 45_000,
  expect: { timeout: 15_000 },
  forbidOnly: process.env.CI !== undefined,
  // .ci/run adds up what the reports of vitest and Playwright count.
  reporter: process.env.CI ? [["list"], ["json", { outputFile: "tests/output/playwright.json" }]] : "list",
  use: {
    viewport: { width: 800, height: 600 },
    launchOptions: { executablePath, args: [...SOFTWARE_WEBGPU_FLAGS] },
  },
  webServer: [serve("tests/e2e/fixture/vite.config.ts", FIXTURE_URL), serve("demo/vite.config.ts", DEMO_URL)],
});
