import { type Browser, chromium } from "@playwright/test";
import { preview } from "vite";
import { findChromium } from "../src/cli/chromium";
import { SOFTWARE_WEBGPU_FLAGS } from "../tests/support/chromium";

/**
 * Serves the demo as built and opens a Chromium with a software adapter for it; closes both afterwards.
 *
 * @param visit - given the address of the site, with a slash at its end.
 */
export async function visitDemo(visit: (browser: Browser, url: string) => Promise<void>): Promise<void> {
  const executablePath = findChromium();
  const server = await preview({ configFile: "demo/vite.config.ts", preview: { port: 41740 }, logLevel: "error" });
  const browser = await chromium.launch({
    args: [...SOFTWARE_WEBGPU_FLAGS],
    ...(executablePath !== undefined && { executablePath }),
  });
  try {
    await visit(browser, server.resolvedUrls!.local[0]!);
  } finally {
    await browser.close();
    await server.close();
  }
}
