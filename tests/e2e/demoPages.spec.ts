import AxeBuilder from "@axe-core/playwright";
import type { Page } from "@playwright/test";
import { FEATURE_NAMES } from "../../demo/features/list";
import { expect, test } from "./support/test";
import { DEMO_URL } from "./support/urls";

const SECTIONS = ["", "features.html", "playground.html", "performance.html"];
const PAGES = [...SECTIONS, ...FEATURE_NAMES.map((name) => `features/${name}.html`)];

test.beforeEach(async ({ page }) => {
  // What is tested here is around the pictures: no time is spent on those.
  await page.addInitScript(() => {
    GPU.prototype.requestAdapter = () => new Promise(() => {});
  });
});

for (const path of PAGES) {
  test(`/${path} keeps to the accessibility rules in light and dark, and fits a phone`, async ({ page }) => {
    await page.setViewportSize({ width: 360, height: 800 });
    await page.goto(DEMO_URL + path);
    if (path === "playground.html") await expect(page.getByText("No mistakes.")).toBeVisible();
    expect(await overflow(page)).toBeLessThanOrEqual(0);
    await page.setViewportSize({ width: 1280, height: 800 });
    expect(await overflow(page)).toBeLessThanOrEqual(0);
    await page.emulateMedia({ colorScheme: "light" });
    expect(await violations(new AxeBuilder({ page }))).toEqual([]);
    await page.emulateMedia({ colorScheme: "dark" });
    expect(await violations(new AxeBuilder({ page }).withRules(["color-contrast"]))).toEqual([]);
  });
}

test("the keyboard gets past the header, and from section to section", async ({ page }) => {
  await page.goto(DEMO_URL);
  await page.keyboard.press("Tab");
  const skip = page.getByRole("link", { name: "Skip to the content" });
  await expect(skip).toBeFocused();
  await expect(skip).toBeInViewport();
  await page.keyboard.press("Enter");
  await expect(page.locator("#main")).toBeFocused();

  for (const name of ["Features", "Playground", "Performance", "Gallery"]) {
    const link = page.getByRole("navigation", { name: "Site" }).getByRole("link", { name });
    await link.press("Enter");
    await expect(link).toHaveAttribute("aria-current", "page");
  }
  await expect(page).toHaveURL(DEMO_URL);
});

test("every link and file of every page is there", async ({ page }) => {
  const missing: string[] = [];
  const known = new Set<string>();
  for (const path of PAGES) {
    await page.goto(DEMO_URL + path);
    const addresses = await page.evaluate(() =>
      [...document.querySelectorAll("[href], [src], [poster]")].map((element) => {
        const address = element.getAttribute("href") ?? element.getAttribute("poster") ?? element.getAttribute("src");
        return new URL(address ?? "", document.baseURI).href.replace(/#.*/, "");
      }),
    );
    for (const address of addresses) if (address.startsWith(DEMO_URL)) known.add(address);
  }
  for (const address of known) if (!(await page.request.get(address)).ok()) missing.push(address);
  expect(known.size).toBeGreaterThan(PAGES.length);
  expect(missing).toEqual([]);
});

/** Each as one line that says where. */
async function violations(axe: AxeBuilder): Promise<string[]> {
  const results = await axe.analyze();
  return results.violations.flatMap(({ id, help, nodes }) =>
    nodes.map(({ target }) => `${id}: ${help}: ${target.join(" ")}`),
  );
}

/** Pixels that stick out to the right. */
function overflow(page: Page): Promise<number> {
  return page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
}
