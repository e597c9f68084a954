import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

const project = (name: string, options: object = {}) => ({
  test: { name, include: [`tests/${name}/**/*.test.ts`], ...options },
});

export default defineConfig({
  test: {
    // .ci/run adds up what the reports of vitest and Playwright count.
    reporters: process.env.CI ? ["default", ["json", { outputFile: "tests/output/vitest.json" }]] : ["default"],
    maxWorkers: "100%", // not one less: of two cores that would be one
    projects: [
      // The demo imports the package by its name.
      project("unit", {
        testTimeout: 30_000, // what takes a second takes ten where other work has the cores
        alias: [{ find: /^rt-viewer$/, replacement: fileURLToPath(new URL("src/index.ts", import.meta.url)) }],
      }),
      project("shaders"),
      // Side by side, though a software adapter takes every core: what checks its results takes one. A minute is for the slowest image.
      project("gpu", { testTimeout: 60_000, hookTimeout: 60_000 }),
    ],
  },
});
