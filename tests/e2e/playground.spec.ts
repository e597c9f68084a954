import type { Locator, Page } from "@playwright/test";
import type { RtViewerElement } from "../../src/element";
import { contrast, difference, pictureOf } from "./support/picture";
import { expect, test } from "./support/test";
import { DEMO_URL } from "./support/urls";
import { pause, waitForSamples } from "./support/viewer";

const PAGE = `${DEMO_URL}playground.html`;

// As on a phone, where the picture is small and quickly made.
test.use({ viewport: { width: 390, height: 844 }, permissions: ["clipboard-read", "clipboard-write"] });

test("a mistake is shown where it is and the picture stays; without it the picture follows", async ({ page }) => {
  const viewer = await openPlayground(page);
  expect(contrast(await pictureOf(viewer))).toBeGreaterThan(10);
  const before = await pictureOf(viewer);

  await replace(page, '"radius": 0.6', '"radius": -1');
  await expect(page.getByText("1 mistake. The picture shows the last scene")).toBeVisible();
  const problem = page.getByRole("list", { name: "Mistakes" }).getByRole("button");
  await expect(problem).toHaveText(/^line \d+ objects\[1\]\.radius: expected a finite number > 0, got -1$/);
  await expect(page.locator(".cm-lintRange-error")).toHaveText('"radius": -1');
  expect(difference(await pictureOf(viewer), before)).toBe(0);

  await problem.click();
  await expect.poll(() => page.evaluate(() => getSelection()?.toString())).toBe('"radius": -1');
  await page.keyboard.insertText('"radius": 0.3');
  await expect(page.getByText("No mistakes.")).toBeVisible();
  await expect.poll(async () => difference(await pictureOf(viewer), before)).toBeGreaterThan(1);
});

test("a text that is no JSON is marked where it breaks", async ({ page }) => {
  await openPlayground(page);
  await replace(page, '"maxBounces": 6', '"maxBounces": six');
  await expect(page.getByRole("button", { name: /^line \d+ Unexpected token 's'/ })).toBeVisible();
});

test("a copied link brings back the text, the exposure and the picture", async ({ page }) => {
  await openPlayground(page);
  await page.getByLabel("Start from").selectOption("A red ball");
  await expect(text(page)).toContainText("0.85");
  await replace(page, "[0.85, 0.05, 0.05]", "[0.05, 0.05, 0.85]");
  await expect(page.getByText("No mistakes.")).toBeVisible();
  await page.getByRole("button", { name: "Copy link" }).click();
  await expect(page.getByRole("button", { name: "Copied" })).toBeVisible();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  expect(page.url()).toBe(link);

  await page.goto("about:blank");
  await page.goto(link);
  await expect(text(page)).toContainText("[0.05, 0.05, 0.85]");
  const viewer = page.locator("rt-viewer");
  await expect(viewer).toHaveAttribute("exposure", "1.5");
  await waitForSamples(viewer, 1);
  await expect(page.getByLabel("Start from")).toHaveValue("");
});

test("an address names an example; the gallery's pictures lead to theirs", async ({ page }) => {
  await page.goto(DEMO_URL);
  await page.locator("#veach").getByRole("link").click();
  await expect(page).toHaveURL(`${PAGE}#example=veach`);
  await expect(page.getByLabel("Start from")).toHaveValue("veach");
  await expect(text(page)).toContainText('"p4"');
});

test("a link that holds no scene, or a hostile one, leaves a page that works", async ({ page }) => {
  for (const hash of ["#scene=%00<script>alert(1)</script>", "#scene=AAAA", `#scene=${"A".repeat(17_000)}`]) {
    await page.goto("about:blank");
    await page.goto(PAGE + hash);
    await expect(page.getByRole("alert").first()).toContainText(/This link .*Here is an example instead/);
    await expect(text(page)).toContainText('"camera"');
    await expect(page.getByText("No mistakes.")).toBeVisible();
  }
  const hostile = '{ "<img src=x onerror=alert(1)>": 1 }';
  await page.goto(PAGE + (await hashOf(page, hostile)));
  const problems = page.getByRole("list", { name: "Mistakes" });
  await expect(problems).toContainText("<img src=x");
  await expect(problems.locator("img")).toHaveCount(0);
});

test("keys are suggested, and Tab leaves the editor", async ({ page }) => {
  await openPlayground(page);
  await select(page, '"maxBounces": 6');
  await page.keyboard.press("Delete");
  await page.keyboard.type('"max');
  const suggestion = page.getByRole("option", { name: /"maxBounces"/ });
  await expect(suggestion).toBeVisible();
  await expect(page.getByText("How often a path may scatter").first()).toBeVisible();
  await suggestion.click();
  await expect(text(page)).toContainText('"maxBounces": 8');
  await expect(page.getByText("No mistakes.")).toBeVisible();
  await page.keyboard.press("Tab");
  await expect(page.locator(".cm-content")).not.toBeFocused();
});

test("the view that was turned to goes into the scene", async ({ page }) => {
  const viewer = await openPlayground(page);
  await viewer.locator("canvas").press("ArrowLeft");
  await page.getByRole("button", { name: "Take this view" }).click();
  await expect(text(page)).not.toContainText('"position": [0, 1.6, 5]');
  await expect(page.getByText("No mistakes.")).toBeVisible();
});

/** Opens the first example and rests its picture, without the panel, so that it changes with the text only. */
async function openPlayground(page: Page): Promise<Locator> {
  await page.goto(PAGE);
  const viewer = page.locator("rt-viewer");
  await waitForSamples(viewer, 1);
  await pause(viewer);
  await viewer.evaluate((element: RtViewerElement) => element.removeAttribute("stats"));
  return viewer;
}

function text(page: Page): Locator {
  return page.locator(".cm-content");
}

async function replace(page: Page, part: string, by: string): Promise<void> {
  await select(page, part);
  await page.keyboard.insertText(by);
}

/** Selects a part of the text with the editor's search. */
async function select(page: Page, part: string): Promise<void> {
  await text(page).press("Control+Home");
  await page.keyboard.press("Control+f");
  await page.getByRole("textbox", { name: "Find" }).pressSequentially(part);
  await page.keyboard.press("Enter");
  await page.keyboard.press("Escape");
  await expect.poll(() => page.evaluate(() => getSelection()?.toString())).toBe(part);
}

async function hashOf(page: Page, scene: string): Promise<string> {
  return page.evaluate(async (given) => {
    const stream = new Blob([given]).stream().pipeThrough(new CompressionStream("deflate-raw"));
    const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
    return `#scene=${btoa(String.fromCharCode(...bytes))
      .replaceAll("+", "-")
      .replaceAll("/", "_")}`;
  }, scene);
}
