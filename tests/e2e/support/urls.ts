/** Where the servers of `playwright.config.ts` are. */
export const FIXTURE_URL = "http://localhost:41731/";
export const DEMO_URL = "http://localhost:41732/";
