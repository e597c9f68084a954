import type { Locator, Page } from "@playwright/test";
import { contrast, pictureOf } from "./support/picture";
import { expect, test } from "./support/test";
import { DEMO_URL } from "./support/urls";

const PAGE = `${DEMO_URL}performance.html`;

type Point = { readonly samples: number; readonly seconds: number; readonly trueError: number | null };
type Copied = {
  readonly adapter: string;
  readonly race: {
    readonly scene: string;
    readonly estimators: Readonly<
      Record<"path" | "uniform", { readonly points: readonly (Point & { readonly estimatedError: number | null })[] }>
    >;
  };
  readonly table: {
    readonly width: number;
    readonly rows: readonly { readonly raysPerPixel: number; readonly fps?: number; readonly error?: number }[];
  };
};

test.use({ permissions: ["clipboard-read", "clipboard-write"] });

test("on spheres our curve runs below the baseline's, and the viewer knows its error", async ({ page }) => {
  await page.goto(PAGE);
  await expect(page.getByText("A CPU stands in for the GPU")).toBeVisible();
  await raceUntil(page, 32);
  expect(await text(page.locator("#verdict"))).toMatch(/^rt-viewer reaches the baseline’s error .*× sooner/);

  const { race, adapter } = await copied(page);
  expect(adapter).toMatch(/swiftshader/i);
  expect(race.scene).toBe("spheres");
  const { path, uniform } = race.estimators;
  for (const { points } of [path, uniform]) expect(points.length).toBeGreaterThanOrEqual(3);
  const ours = path.points.at(-1)!;
  expect(ours.trueError!).toBeLessThan(uniform.points.at(-1)!.trueError!);
  const ratio = ours.estimatedError! / ours.trueError!;
  expect(ratio).toBeGreaterThan(1 / 1.5);
  expect(ratio).toBeLessThan(1.5);

  for (const curve of ["path", "uniform"]) {
    await expect(page.locator(`#plot .truth.${curve}`)).toHaveCount(1);
    await expect(page.locator(`#plot .estimate.${curve}`)).toHaveCount(1);
    expect(contrast(await pictureOf(page.locator(`canvas.${curve}`)))).toBeGreaterThan(10);
  }
});

test("a stopped race goes on, and another scene starts another one", async ({ page }) => {
  await page.goto(PAGE);
  await raceUntil(page, 4);
  const before = await samples(page, "path");
  await page.getByRole("button", { name: "Continue" }).click();
  await expect.poll(() => samples(page, "path")).toBeGreaterThan(before);

  await page.getByRole("radio", { name: "Red ball" }).check();
  await expect(page.getByRole("img", { name: "Red ball, rendered by rt-viewer" })).toBeVisible();
  await raceUntil(page, 4);
  expect((await copied(page)).race.scene).toBe("bleed");
});

test("the original's table fills in, and what is copied holds its figures", async ({ page }) => {
  await page.goto(PAGE);
  const button = page.locator("#measure");
  await expect(button).toBeEnabled();
  await button.click();
  const cells = page.locator("#settings tbody tr").first().locator("td");
  await expect(cells.last()).toHaveText(/\d %/);
  await button.click();
  await expect(button).toHaveText("Continue");

  const { table } = await copied(page);
  const [first] = table.rows;
  expect(table.rows).toHaveLength(10);
  expect(table.width).toBe(320);
  expect(first!.raysPerPixel).toBe(5);
  expect(Number(await text(cells.nth(1)))).toBeCloseTo(first!.fps!, first!.fps! < 1 ? 1 : 0);
  expect(Number.parseFloat(await text(cells.nth(2))) / 100).toBeCloseTo(first!.error!, 3);
  expect(first!.error!).toBeGreaterThan(0);
  expect(first!.error!).toBeLessThan(Number.parseFloat(await text(cells.last())) / 100);
});

test("where the clipboard is denied, the results are there to be copied by hand", async ({ page }) => {
  await page.addInitScript(() => {
    navigator.clipboard.writeText = () => Promise.reject(new DOMException("denied", "NotAllowedError"));
  });
  await page.goto(PAGE);
  await page.getByRole("button", { name: "Copy results" }).first().click();
  const results = await page.getByRole("dialog").getByLabel("Results").inputValue();
  expect(JSON.parse(results)).toMatchObject({ softwareAdapter: true });
});

test("without WebGPU the page says so", async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(Navigator.prototype, "gpu", { value: undefined });
  });
  await page.goto(PAGE);
  await expect(page.getByRole("alert")).toContainText("WebGPU is not available");
  await expect(page.locator("#run")).toBeDisabled();
  await expect(page.locator("#settings tbody tr")).toHaveCount(10);
});

test("the two pages lead to each other", async ({ page }) => {
  await page.goto(DEMO_URL);
  await page.getByRole("navigation").getByRole("link", { name: "Performance" }).click();
  await expect(page).toHaveURL(PAGE);
  await expect(page.getByRole("link", { name: "Performance" })).toHaveAttribute("aria-current", "page");
  await page.getByRole("navigation").getByRole("link", { name: "Gallery" }).click();
  await expect(page).toHaveURL(DEMO_URL);
});

for (const width of [360, 1280]) {
  test(`nothing sticks out of a performance page ${width} px wide`, async ({ page }) => {
    await page.setViewportSize({ width, height: 800 });
    await page.goto(PAGE);
    await raceUntil(page, 2);
    const overflow = () => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(await overflow()).toBeLessThanOrEqual(0);
  });
}

/** Stops the race, which starts by itself, once both pictures have so many samples per pixel and a point to show for it. */
async function raceUntil(page: Page, count: number): Promise<void> {
  const slower = async () => Math.min(await samples(page, "path"), await samples(page, "uniform"));
  await expect.poll(slower, { intervals: [100] }).toBeGreaterThanOrEqual(count);
  await page.getByRole("button", { name: "Stop" }).click();
  await expect(page.locator("#run")).toHaveText("Continue");
}

async function samples(page: Page, estimator: "path" | "uniform"): Promise<number> {
  const cell = page.locator(`.figures [data-lane="${estimator}"][data-figure="samples"]`);
  return Number((await text(cell)).replaceAll(",", "")) || 0;
}

/** What the button puts on the clipboard. */
async function copied(page: Page): Promise<Copied> {
  const button = page.locator("[data-copy]").first();
  await button.click();
  await expect(button).toHaveText(/Copied/);
  return JSON.parse(await page.evaluate(() => navigator.clipboard.readText())) as Copied;
}

async function text(locator: Locator): Promise<string> {
  return (await locator.innerText()).trim();
}
