import { test as base, expect } from "@playwright/test";

type Fixtures = {
  /** Console errors that the test brings about; every other one fails it. */
  expectedErrors: RegExp[];
  watchConsole: undefined;
};

/** Playwright's `test`, failing on errors in the console and on uncaught ones. */
export const test = base.extend<Fixtures>({
  expectedErrors: async ({ page: _ }, use) => use([]),
  watchConsole: [
    async ({ page, expectedErrors }, use) => {
      const errors: string[] = [];
      page.on("pageerror", (error) => errors.push(String(error.stack ?? error)));
      page.on("console", (message) => {
        if (message.type() === "error") errors.push(message.text());
      });
      await use(undefined);
      expect(errors.filter((text) => !expectedErrors.some((pattern) => pattern.test(text)))).toEqual([]);
    },
    { auto: true },
  ],
});

export { expect };
