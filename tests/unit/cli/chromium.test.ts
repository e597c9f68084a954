import { chmodSync, mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { delimiter, dirname, join } from "node:path";
import { afterEach, beforeEach, expect, test } from "vitest";
import { chromiumCandidates, findChromium, softwareAdapterManifest } from "../../../src/cli/chromium";

let folder: string;

beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), "rt-viewer-"));
});
afterEach(() => {
  rmSync(folder, { recursive: true });
});

/** Makes a file that could be started, at a path inside the test's folder. */
function install(path: string, mode = 0o755): string {
  const file = join(folder, path);
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, "#!/bin/sh\n");
  chmodSync(file, mode);
  return file;
}

test("a Chromium named by the environment comes first, Playwright's own last", () => {
  const environment = { PATH: ["/a", "/b"].join(delimiter), CHROME_PATH: "/opt/chrome", RT_VIEWER_CHROMIUM: "/mine" };
  const candidates = chromiumCandidates(environment, "/playwright/chrome");
  expect(candidates.slice(0, 4)).toEqual(["/mine", "/opt/chrome", "/a/chromium", "/b/chromium"]);
  expect(candidates).toContain("/b/google-chrome");
  expect(candidates.at(-1)).toBe("/playwright/chrome");
});

test("nothing named and nothing on the path leaves nothing", () => {
  expect(chromiumCandidates({})).toEqual([]);
  expect(chromiumCandidates({ PATH: "", RT_VIEWER_CHROMIUM: "" }, "")).toEqual([]);
});

test("chromium anywhere on the path is preferred to another name earlier on it", () => {
  install("first/google-chrome");
  const chromium = install("second/chromium");
  const PATH = [join(folder, "first"), join(folder, "second")].join(delimiter);
  expect(findChromium({ PATH })).toBe(chromium);
});

test("a file that cannot be started is passed over", () => {
  install("first/chromium", 0o644);
  const chrome = install("second/chrome");
  const PATH = [join(folder, "first"), join(folder, "second"), join(folder, "missing")].join(delimiter);
  expect(findChromium({ PATH, CHROME_PATH: join(folder, "gone") })).toBe(chrome);
});

test("the software adapter's manifest is found beside the browser a link leads to", () => {
  const browser = install("lib/chromium/chromium");
  const manifest = install("lib/chromium/vk_swiftshader_icd.json", 0o644);
  mkdirSync(join(folder, "bin"));
  symlinkSync(browser, join(folder, "bin/chromium"));
  expect(softwareAdapterManifest({ PATH: join(folder, "bin") })).toBe(manifest);
});

test("the manifest of another browser is found when the first one has none", () => {
  install("bare/chromium");
  const complete = install("complete/chrome");
  const manifest = install("complete/vk_swiftshader_icd.json", 0o644);
  expect(softwareAdapterManifest({ RT_VIEWER_CHROMIUM: join(folder, "bare/chromium"), CHROME_PATH: complete })).toBe(
    manifest,
  );
});
