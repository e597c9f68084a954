// Renderers in Python: a process per scene that prints a line of JSON about itself, then one per image.
import { spawn } from "node:child_process";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import type { Measurement, MeasureOptions, TimedImage } from "./measurement";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

// A process that has not ended by then never will.
const LIMIT_MS = 20 * 60_000;

export type PythonRival = {
  readonly id: "mitsuba" | "cycles";
  /** The package that a Python needs, as one would name it. */
  readonly needs: string;
  /** Names a Python that has it. */
  readonly variable: string;
};

export const PYTHON_RIVALS: readonly PythonRival[] = [
  { id: "mitsuba", needs: "mitsuba", variable: "RT_VIEWER_MITSUBA_PYTHON" },
  { id: "cycles", needs: "bpy", variable: "RT_VIEWER_CYCLES_PYTHON" },
];

/** The first Python that has what the rival needs: of the variable, or `python3`. */
export async function findPython({ id, variable }: PythonRival): Promise<string | undefined> {
  for (const python of [process.env[variable], "python3"]) {
    if (python === undefined || python === "") continue;
    const isThere = await run(python, [scriptOf(id), "--check"]).then(
      () => true,
      () => false,
    );
    if (isThere) return python;
  }
  return undefined;
}

/** @param sceneFile - a scene in rt-viewer's format. */
export async function measurePython(
  python: string,
  id: PythonRival["id"],
  sceneFile: string,
  { width, samples, seed }: MeasureOptions,
): Promise<Measurement> {
  const folder = await mkdtemp(join(tmpdir(), "rt-viewer-bench-"));
  try {
    const options = { size: width, samples: samples.join(","), seed, out: folder };
    const args = Object.entries(options).flatMap(([name, value]) => [`--${name}`, String(value)]);
    const [about, ...images] = parseLines(await run(python, [scriptOf(id), sceneFile, ...args]));
    const { renderer, setupSeconds, threads } = about as { renderer: string; setupSeconds: number; threads: number };
    return {
      renderer,
      adapter: `CPU, ${threads} ${threads === 1 ? "thread" : "threads"}`,
      setupSeconds,
      images: await Promise.all(images.map((line) => readImage(line as ImageLine))),
    };
  } finally {
    await rm(folder, { recursive: true });
  }
}

/** The lines of an output that are JSON objects; renderers print others of their own. */
export function parseLines(output: string): unknown[] {
  return output
    .split("\n")
    .filter((line) => line.startsWith("{"))
    .map((line) => JSON.parse(line) as unknown);
}

type ImageLine = { readonly samples: number; readonly seconds: number; readonly file: string };

async function readImage({ samples, seconds, file }: ImageLine): Promise<TimedImage> {
  const bytes = await readFile(file);
  const radiance = new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
  return { samples, seconds, radiance };
}

function scriptOf(id: PythonRival["id"]): string {
  return here(`rivals/${id}_rival.py`);
}

/** What a command prints. Rejects, with the end of what it complained about, if it fails. */
function run(command: string, args: readonly string[]): Promise<string> {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, { timeout: LIMIT_MS });
    let stdout = "";
    let stderr = "";
    child.stdout.on("data", (chunk) => {
      stdout += chunk;
    });
    child.stderr.on("data", (chunk) => {
      stderr += chunk;
    });
    child.on("error", reject);
    child.on("close", (code, signal) => {
      if (code === 0) resolve(stdout);
      else reject(new Error(`${command} ended with ${code ?? signal}: ${stderr.trim().split("\n").at(-1)}`));
    });
  });
}
