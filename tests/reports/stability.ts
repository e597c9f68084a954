import { spawnSync } from "node:child_process";
import { readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import type { StabilityRow } from "../support/stabilityRows";

const ROWS = new URL("../output/stability/", import.meta.url);
const REPORT = new URL("stability.md", import.meta.url);

/** Sections of the report, by the name of the rows' file. */
const SECTIONS: readonly (readonly [title: string, ...files: string[]])[] = [
  ["Meeting surfaces", "edges", "mesh-leaks", "planes", "spheres"],
  ["Leaving surfaces", "spawn", "mesh-spawn", "rooms"],
  ["Images", "invariance", "sizes", "floor", "telephoto"],
  ["Lights", "sphere-lights", "light-sampling"],
  ["The film", "film"],
  ["Scattering", "bsdf", "bsdf-finite", "bsdf-terms", "sampling", "multiscatter"],
];

const INTRODUCTION = `# Numerical stability

Written by \`npm run report:stability\`; don't edit. Every row is a test of \`npm test\` with a 64-bit oracle (\`tests/support\`).
"Textbook" is what the textbook's formulas make of the same inputs on the same device: the quadratic formula, Möller–Trumbore,
parallelograms without rims, hits closer than 10⁻⁴ ignored, coordinates in f32 as they are written. Errors are lengths in the
scene's units where a row asserts a length, else relative.

![Light lost off a floor of radius 10⁵: textbook left, rt-viewer right](floor-self-hits.png)

*A floor that is a sphere of radius 10⁵, seen from a height of 1.6. The darker, the more of the rays that leave it there meet it
again and lose their light; on a convex floor none should. Left: quadratic formula, t > 10⁻⁴. Right: rt-viewer.*
`;

const COST = `## What it costs

CPU time per path on SwiftShader, values in uniforms, 256², the least of six runs, before and after all measures in turn:
\`cornell\` 1.35 → 1.45 µs (+8 %), \`spheres\` 0.87 → 0.87 µs (the runs differ by 5 %). Leaving out one measure at a time on
\`cornell\`, of 0.909 µs with constants: hit points drawn back onto flat shapes 0.040, box normals 0.025, rims of quads 0.020,
the film's carry 0.007. The common order of vertices is made on the CPU and costs nothing.

A scene pays for what it can hit only: flat shapes are drawn together where there are at least two, spheres are measured from
the ground where one is huge, \`multiscatter\` is compiled where a material asks for it.
`;

/**
 * `npm run report:stability`: runs the stability tests and writes `stability.md` from what they found.
 * `npm run test:long` (`--long`): the same tests with ten times the inputs, and no report.
 */
export function main(args: readonly string[]): void {
  const isLong = args.includes("--long");
  if (!isLong) rmSync(ROWS, { recursive: true, force: true });
  const tests = ["tests/gpu/stability", "tests/gpu/bsdf", "tests/gpu/meshes"];
  const { status } = spawnSync("npx", ["vitest", "run", "--project", "gpu", "--testTimeout=600000", ...tests], {
    stdio: "inherit",
    shell: process.platform === "win32",
    env: { ...process.env, ...(isLong ? { RT_VIEWER_LONG: "1" } : { RT_VIEWER_REPORT: "1" }) },
  });
  if (status !== 0) process.exit(1);
  if (!isLong) writeReport();
}

/** Writes the report from the rows that are there. */
export function writeReport(): void {
  writeFileSync(REPORT, report());
}

function report(): string {
  const files = new Set(readdirSync(ROWS).map((file) => file.replace(/\.json$/, "")));
  const known = SECTIONS.flatMap(([, ...names]) => names);
  const others = [...files].filter((file) => !known.includes(file)).sort();
  const sections = [...SECTIONS, ...(others.length > 0 ? [["More", ...others] as const] : [])];
  const parts = sections.flatMap(([title, ...names]) => {
    const rows = names.filter((name) => files.has(name)).flatMap(readRows);
    return rows.length > 0 ? [`## ${title}\n\n${table(rows)}`] : [];
  });
  return [INTRODUCTION, ...parts, COST].join("\n");
}

function readRows(name: string): StabilityRow[] {
  return JSON.parse(readFileSync(new URL(`${name}.json`, ROWS), "utf8")) as StabilityRow[];
}

function table(rows: readonly StabilityRow[]): string {
  const lines = rows.map((row) =>
    [row.case, row.asserted, row.inputs.toLocaleString("en-US"), figure(row.worst), figure(row.textbook)]
      .map((cell) => cell.replaceAll("|", "\\|"))
      .join(" | "),
  );
  const head = ["case", "asserted", "inputs", "worst of ours", "textbook"].join(" | ");
  return `| ${head} |\n|---|---|---:|---|---|\n${lines.map((line) => `| ${line} |`).join("\n")}\n`;
}

function figure(value: number | string | undefined): string {
  if (typeof value !== "number") return value ?? "–";
  return Number.isInteger(value) ? value.toLocaleString("en-US") : value.toExponential(1);
}
