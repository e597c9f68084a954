import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { decode } from "fast-png";
import { afterAll, describe, expect, test } from "vitest";
import { triangleFile, variantFile } from "../support/gltf";
import { everythingFile } from "../support/gltfEverything";

const ROOT = fileURLToPath(new URL("../..", import.meta.url));
const CORNELL = "tests/reference/scenes/cornell.json";
const KEYS = ["adapter", "width", "height", "samples", "seconds", "compileSeconds", "mpaths", "error", "badSamples"];

const folder = mkdtempSync(join(tmpdir(), "rt-viewer-cli-"));
afterAll(() => rmSync(folder, { recursive: true }));

type Outcome = { readonly code: number | null; readonly stdout: string; readonly stderr: string };

/** `npm run render -- …args` in a process of its own. */
function render(...args: string[]): Promise<Outcome> {
  return new Promise((resolve, reject) => {
    const child = spawn("npm", ["run", "--silent", "render", "--", ...args], { cwd: ROOT });
    let stdout = "";
    let stderr = "";
    child.stdout.on("data", (chunk) => {
      stdout += chunk;
    });
    child.stderr.on("data", (chunk) => {
      stderr += chunk;
    });
    child.on("error", reject);
    child.on("close", (code) => resolve({ code, stdout, stderr }));
  });
}

function figuresOf({ stdout }: Outcome): Record<string, unknown> {
  return JSON.parse(stdout.trim().split("\n").at(-1)!) as Record<string, unknown>;
}

function sceneFile(name: string, scene: unknown): string {
  const path = join(folder, name);
  const isContent = typeof scene === "string" || scene instanceof Uint8Array;
  writeFileSync(path, isContent ? scene : JSON.stringify(scene));
  return path;
}

describe("npm run render, seed 7", () => {
  test("writes a picture and, last on stdout, its figures as JSON", async () => {
    const out = join(folder, "cornell.png");
    const outcome = await render(CORNELL, "--size", "60x40", "--samples", "16", "--seed", "7", "--out", out);
    expect(outcome.stderr).toBe("");
    expect(outcome.code).toBe(0);
    const figures = figuresOf(outcome);
    expect(Object.keys(figures)).toEqual(expect.arrayContaining(KEYS));
    expect(figures).toMatchObject({ width: 60, height: 40, samples: 16, badSamples: 0 });
    expect(figures.adapter).toMatch(/\S/);
    for (const key of ["seconds", "compileSeconds", "mpaths", "error"]) expect(figures[key]).toBeGreaterThan(0);
    expect(figures.mpaths).toBeCloseTo((60 * 40 * 16) / (figures.seconds as number) / 1e6, 6);

    const { width, height, channels, data } = decode(readFileSync(out));
    expect([width, height, channels]).toEqual([60, 40, 4]);
    const lit = data.filter((value, i) => i % 4 < 3 && value > 16).length;
    // The room fills the middle two thirds of the picture; shadows and blue in the red wall are darker than this.
    expect(lit).toBeGreaterThan((0.75 * data.length) / 3);
    expect(data.every((value, i) => i % 4 < 3 || value === 255)).toBe(true);
  });

  test("writes linear floats, bottom row first, and takes its other options", async () => {
    const out = join(folder, "sky.pfm");
    // Above the horizon the sky, below it a black floor.
    const scene = sceneFile("sky.json", {
      camera: { position: [0, 1, 0], target: [0, 1, -1], verticalFov: 60 },
      materials: { black: { baseColor: [0, 0, 0], ior: 1 } },
      objects: [{ type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material: "black" }],
      environment: { radiance: [0.25, 0.5, 4] },
    });
    const options = ["--bounces", "2", "--estimator", "uniform", "--sampler", "independent", "--light-samples", "2"];
    const outcome = await render(scene, "--size", "6x4", "--samples", "8", ...options, "--out", out);
    expect(outcome.stderr).toBe("");
    expect(outcome.code).toBe(0);
    const bytes = readFileSync(out);
    const header = "PF\n6 4\n-1.0\n";
    expect(bytes.subarray(0, header.length).toString("latin1")).toBe(header);
    expect(bytes.length).toBe(header.length + 4 * 3 * 6 * 4);
    const values = Array.from({ length: 3 * 6 * 4 }, (_, i) => bytes.readFloatLE(header.length + 4 * i));
    const half = values.length / 2;
    expect(values.slice(0, half)).toEqual(Array(half).fill(0));
    expect(values.slice(half)).toEqual(
      Array(half / 3)
        .fill([0.25, 0.5, 4])
        .flat(),
    );
  });

  test("takes a .glb with pictures in it, and says what it leaves out", async () => {
    const out = join(folder, "glb.png");
    const outcome = await render(
      sceneFile("x.glb", everythingFile({ animations: [{}] })),
      "--size",
      "32x24",
      "--out",
      out,
    );
    expect(outcome.stderr).toBe("Animations are not supported: the pose at rest is shown\n");
    expect(outcome.code).toBe(0);
    const { data } = decode(readFileSync(out));
    expect(new Set(data).size).toBeGreaterThan(10);
  });

  test("shows a variant of a .glb", async () => {
    const out = join(folder, "variant.png");
    const file = sceneFile("variants.glb", variantFile());
    const outcome = await render(file, "--variant", "Blue", "--size", "32x24", "--samples", "16", "--out", out);
    expect(outcome.stderr).toBe("");
    expect(outcome.code).toBe(0);
    const { data } = decode(readFileSync(out));
    const sum = (channel: number) => [...data].reduce((sum, value, i) => sum + (i % 4 === channel ? value : 0), 0);
    expect(sum(2)).toBeGreaterThan(1.1 * sum(0)); // all but the triangle is grey
  });

  test("stops at the target error", async () => {
    const outcome = await render(CORNELL, "--size", "32x32", "--samples", "4096", "--target-error", "0.2");
    expect(outcome.code).toBe(0);
    const { error, samples } = figuresOf(outcome);
    expect(error).toBeLessThanOrEqual(0.2);
    expect(samples).toBeLessThan(4096);
  });
});

describe("npm run render ends with exit code 1, a message and no file", () => {
  const cornell = JSON.parse(readFileSync(join(ROOT, CORNELL), "utf8")) as { objects: object[] };
  const broken = { ...cornell, maxBounces: -1, objects: [{ ...cornell.objects[0], material: "nowhere" }] };

  const cases: Readonly<Record<string, { args: () => string[]; says: string[] }>> = {
    "for a faulty scene, naming every fault": {
      args: () => [sceneFile("broken.json", broken)],
      says: ["maxBounces: expected an integer from 0", 'objects[0].material: no material is named "nowhere"'],
    },
    "for half of a .glb": {
      args: () => [sceneFile("half.glb", triangleFile().subarray(0, 300))],
      says: ["half.glb is cut off: it should have"],
    },
    "for text that is not JSON": { args: () => [sceneFile("text.json", "not JSON")], says: ["text.json is not JSON"] },
    "for a file that is not there": { args: () => [join(folder, "none.json")], says: ["could not read", "none.json"] },
    "for no file": { args: () => [], says: ["expected one scene file", "Usage:"] },
    "for an unknown option": { args: () => [CORNELL, "--colour", "red"], says: ["--colour", "Usage:"] },
    "for a bad size": { args: () => [CORNELL, "--size", "0x5"], says: ["--size: expected", "got 0x5"] },
    "for a bad number of samples": { args: () => [CORNELL, "--samples", "x"], says: ["--samples: expected", "got x"] },
    "for a variant that the file does not have": {
      args: () => [sceneFile("variants.glb", variantFile()), "--variant", "Moon"],
      says: ["--variant: ", 'variants.glb has no variant "Moon": it has "Red", "Blue"'],
    },
    "for an unknown estimator": {
      args: () => [CORNELL, "--estimator", "best"],
      says: ["--estimator: expected path or uniform, got best"],
    },
  };

  test.each(Object.keys(cases))("%s", async (name) => {
    const { args, says } = cases[name]!;
    const out = join(folder, `${name}.png`);
    const outcome = await render(...args(), "--out", out);
    for (const text of says) expect(outcome.stderr).toContain(text);
    expect(outcome.stderr).not.toMatch(/\n\s+at /); // no stack
    expect(outcome.stdout).toBe("");
    expect(outcome.code).toBe(1);
    expect(existsSync(out)).toBe(false);
  });

  test("for a picture of an unknown kind", async () => {
    const out = join(folder, "picture.bmp");
    const outcome = await render(CORNELL, "--out", out);
    expect(outcome.stderr).toContain("--out: expected a file that ends in .png or .pfm");
    expect(outcome.code).toBe(1);
    expect(existsSync(out)).toBe(false);
  });
});
