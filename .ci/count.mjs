// Prints the totals of vitest's and Playwright's reports; fails if a test failed, a report is missing, or nothing ran.
import { readFileSync } from "node:fs";

const read = (name) => {
  try {
    return JSON.parse(readFileSync(`tests/output/${name}.json`, "utf8"));
  } catch {
    return undefined; // that runner did not get to its end
  }
};

const vitest = read("vitest");
const playwright = read("playwright");
// A file that does not load and a server that does not start have no tests to fail; each counts as one.
const unloaded = vitest?.testResults.filter((file) => file.status === "failed" && file.assertionResults.length === 0);
const counts = {
  passed: [vitest?.numPassedTests, playwright?.stats.expected, playwright?.stats.flaky],
  failed: [vitest?.numFailedTests, unloaded?.length, playwright?.stats.unexpected, playwright?.errors.length],
};
const total = (numbers) => numbers.reduce((sum, number) => sum + (number ?? 0), 0);

console.log(`${total(counts.passed)} passed, ${total(counts.failed)} failed`);
process.exitCode = vitest && playwright && total(counts.passed) > 0 && total(counts.failed) === 0 ? 0 : 1;
