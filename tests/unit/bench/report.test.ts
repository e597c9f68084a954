import { describe, expect, test } from "vitest";
import { reportOf } from "../../bench/report";
import type { Results, Row } from "../../bench/results";

const ours: Row = {
  scene: "cornell",
  id: "ours",
  renderer: "rt-viewer",
  host: "Chromium",
  adapter: "google · swiftshader",
  samples: 64,
  isMain: true,
  seconds: [2, 9, 1],
  setupSeconds: 0.25,
  relMse: 0.01,
  uncertainty: 0.05,
  bias: { excess: 0.001, sigmas: 0.4, bound: 0.004 },
};
const rival: Row = {
  ...ours,
  id: "mitsuba",
  renderer: "Mitsuba",
  host: "Python",
  adapter: "CPU, 2 threads",
  seconds: [4],
  relMse: 0.02,
};

const results: Results = {
  machine: { cpu: "CPU", cores: 2, system: "Linux", node: "20", date: "2030-01-02" },
  protocol: { size: 256, samples: 64, runs: 3 },
  rows: [ours, rival, { ...ours, samples: 16, isMain: false }],
  notMeasured: [{ id: "cycles", reason: "no Python with bpy" }],
  estimates: [],
  frames: [],
};

/** The cells of the first line of a report that begins with `start`. */
function cells(report: string, start: string): string[] {
  const line = report.split("\n").find((line) => line.startsWith(`| ${start}`))!;
  return line
    .split("|")
    .slice(1, -1)
    .map((cell) => cell.trim());
}

describe("a scene's table", () => {
  const section = reportOf(results, []).split("## cornell")[1]!;

  test("names renderer, place, speed, error and efficiency", () => {
    // 256² · 64 / 2 s = 2.10 M/s; 1/(0.01 · 2) = 50.
    expect(cells(section, "rt-viewer")).toEqual([
      ..."rt-viewer|Chromium, SwiftShader (software, no GPU)|64|2.1|1.00e-2 ± 5 %|2|0.25|50|1|< 0.4 %".split("|"),
    ]);
  });

  test("divides our efficiency by theirs", () => {
    // 50 / (1/(0.02 · 4)) = 4.
    expect(cells(section, "Mitsuba")[8]).toBe("4");
  });

  test("gives what is wrong beyond noise where chance does not explain it", () => {
    const wrong = { ...ours, bias: { excess: 0.05, sigmas: 9, bound: 0.06 } };
    expect(cells(reportOf({ ...results, rows: [wrong] }, []).split("## cornell")[1]!, "rt-viewer")[9]).toBe("5 %");
  });

  test("leaves the plots' sample counts to the plots", () => {
    expect(section.match(/^\| rt-viewer/gm)).toHaveLength(1);
  });
});

test("compares Python's renderers with Chromium where it was measured", () => {
  const dawn: Row = { ...ours, host: "Dawn in Node", seconds: [4] };
  const section = reportOf({ ...results, rows: [dawn, ...results.rows] }, []).split("## cornell")[1]!;
  expect(cells(section, "Mitsuba")[8]).toBe("4");
});

test("says who was not measured, and why", () => {
  expect(reportOf(results, [])).toContain("- cycles: no Python with bpy");
});

test("shows each scene's plot", () => {
  expect(reportOf(results, [{ file: "cornell.svg", caption: "cornell" }])).toContain("![cornell](plots/cornell.svg)");
});
