import { readFile } from "node:fs/promises";
import { join } from "node:path";
import type { Page } from "@playwright/test";
import { test as base, expect } from "../../e2e/support/test";
import { Project } from "./project";

/** Playwright's `test`, with one project of a stranger for all tests. */
export const test = base.extend<object, { project: Project }>({
  project: [
    // biome-ignore lint/correctness/noEmptyPattern: Playwright wants to see which fixtures are used
    async ({}, use) => {
      const project = await Project.create();
      await use(project);
      await project.dispose();
    },
    { scope: "worker", timeout: 60_000 },
  ],
});

export { expect };

const TYPES: Readonly<Record<string, string>> = {
  html: "text/html",
  js: "text/javascript",
  json: "application/json",
};

/** Answers the page's requests to an address with the files of folders, the first that has one, as a server elsewhere would. */
export async function serve(page: Page, origin: string, ...folders: readonly string[]): Promise<void> {
  await page.route(`${origin}/**`, async (route) => {
    const path = new URL(route.request().url()).pathname;
    for (const folder of folders) {
      const body = await readFile(join(folder, path)).catch(() => undefined);
      if (body === undefined) continue;
      const contentType = TYPES[path.split(".").at(-1) ?? ""] ?? "application/octet-stream";
      return route.fulfill({ body, contentType, headers: { "Access-Control-Allow-Origin": "*" } });
    }
    return route.fulfill({ status: 404 });
  });
}
