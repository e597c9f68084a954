import { fileURLToPath } from "node:url";
import { chromium, type Page } from "@playwright/test";
import { build, preview } from "vite";
import { findChromium } from "../../src/cli/chromium";
import { RtViewerError } from "../../src/errors";
import { SOFTWARE_WEBGPU_FLAGS } from "../support/chromium";
import type { Host, Measure } from "./measurement";
import type { measureBumpy } from "./page/bumpy";
import type { measureDrop } from "./page/drop";
import type { PageBench } from "./page/main";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

// A page that has not answered by then never will.
const LIMIT_MS = 20 * 60_000;

export type ChromiumHost = Host & {
  readonly version: string;
  readonly threeGpuPathTracer: Measure;
  readonly bumpy: typeof measureBumpy;
  readonly drop: typeof measureDrop;
  close(): Promise<void>;
};

/**
 * Builds the benchmark's page, serves it and starts a browser. Every measurement gets a fresh page.
 *
 * @param usesGpu - the machine's own driver instead of the software adapter.
 * @throws {RtViewerError} if no Chromium is installed.
 */
export async function openChromium(usesGpu: boolean): Promise<ChromiumHost> {
  const executablePath = findChromium();
  if (executablePath === undefined) {
    throw new RtViewerError("no Chromium found; name one in RT_VIEWER_CHROMIUM, or measure with --host dawn");
  }
  const outDir = here("../output/bench-page");
  const shared = { root: here("page"), configFile: false, logLevel: "error" } as const;
  await build({ ...shared, build: { target: "es2022", outDir, emptyOutDir: true, chunkSizeWarningLimit: 10_000 } });
  const server = await preview({ ...shared, build: { outDir }, preview: { port: 0 } });
  const browser = await chromium.launch({ executablePath, args: flags(usesGpu) }).catch(async (error: unknown) => {
    await server.close();
    throw error;
  });
  const url = server.resolvedUrls!.local[0]!;

  async function inPage<T>(use: (page: Page) => Promise<T>): Promise<T> {
    const page = await browser.newPage();
    const timer = setTimeout(() => page.close(), LIMIT_MS);
    try {
      await page.goto(url);
      await page.waitForFunction(() => globalThis.bench !== undefined);
      return await use(page);
    } finally {
      clearTimeout(timer);
      await page.close();
    }
  }

  /** Calls one function of the page. */
  const call = <K extends keyof PageBench>(name: K, ...args: Parameters<PageBench[K]>) =>
    inPage((page) =>
      page.evaluate(([name, args]) => (globalThis.bench[name as K] as (...args: unknown[]) => unknown)(...args), [
        name,
        args,
      ] as const),
    ) as ReturnType<PageBench[K]>;

  return {
    name: "Chromium",
    version: browser.version(),
    measure: (variant, scene, options) => call("measureOurs", variant, scene, options),
    estimates: (scene, options) => call("measureEstimates", scene, options),
    frames: (scene, options) => call("measureFrames", scene, options),
    threeGpuPathTracer: (scene, options) => call("measureThreeGpuPathTracer", scene, options),
    bumpy: (...args) => call("measureBumpy", ...args),
    drop: (triangles) => call("measureDrop", triangles),
    async close() {
      await browser.close();
      await server.close();
    },
  };
}

function flags(usesGpu: boolean): string[] {
  if (!usesGpu) return [...SOFTWARE_WEBGPU_FLAGS];
  const isSoftware = (flag: string) => /swiftshader|--use-gl=/.test(flag);
  const isForLinux = (flag: string) => flag === "--enable-features=Vulkan";
  return SOFTWARE_WEBGPU_FLAGS.filter(
    (flag) => !isSoftware(flag) && (process.platform === "linux" || !isForLinux(flag)),
  );
}
