import { describe, expect, test } from "vitest";
import { drawPlot, type Plot, spread } from "../../bench/plot";

const plot: Plot = {
  title: "a < b & c",
  notes: ["note"],
  x: { title: "seconds", format: String },
  y: { title: "error", format: String },
  series: [
    { name: "one", detail: "first", points: [{ x: 0.1, y: 1 }] },
    // biome-ignore format: one point per column
    { name: "two", detail: "second", points: [{ x: 1, y: 0.1 }, { x: 10, y: 0.01 }] },
  ],
};

describe("spread", () => {
  test("leaves what is far enough apart", () => {
    expect(spread([10, 30, 60], 16, 100)).toEqual([10, 30, 60]);
  });

  test("moves what is too close down, and up again at the lower end", () => {
    expect(spread([10, 11, 12], 16, 100)).toEqual([10, 26, 42]);
    expect(spread([90, 95, 99], 16, 100)).toEqual([68, 84, 100]);
  });
});

test("words are escaped", () => {
  expect(drawPlot(plot)).toContain("a &lt; b &amp; c");
});

test("a decade is as long anywhere on an axis", () => {
  const markers = [...drawPlot(plot).matchAll(/class="marker"[^>]*translate\(([\d.]+) ([\d.]+)\)/g)];
  const [first, second, third] = markers.map(([, x, y]) => [Number(x), Number(y)] as const);
  expect(second![0] - first![0]).toBeCloseTo(third![0] - second![0], 0);
  expect(second![1] - first![1]).toBeCloseTo(third![1] - second![1], 0);
});

test("decades are labelled, and 2 and 5 if there are few", () => {
  const labels = (svg: string) => [...svg.matchAll(/text-anchor="middle">([\d.]+)</g)].map(([, label]) => label);
  expect(labels(drawPlot(plot))).toEqual(["0.1", "1", "10"]);
  // biome-ignore format: one point per column
  const narrow = [{ name: "n", points: [{ x: 1, y: 1 }, { x: 6, y: 2 }] }];
  expect(labels(drawPlot({ ...plot, series: narrow }))).toEqual(["1", "2", "5"]);
});

test("points to judge by agreement have no lines, and a band", () => {
  const svg = drawPlot({ ...plot, isAgreement: true });
  expect(svg).not.toContain("<polyline");
  expect(svg).toContain(`class="band"`);
});
