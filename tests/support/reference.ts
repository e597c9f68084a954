import { readFileSync } from "node:fs";
import type { Scene } from "../../src/scene/schema";

const FOLDER = new URL("../reference/", import.meta.url);

/** A converged image of a reference scene, made by Mitsuba. */
export type Reference = {
  readonly scene: Scene;
  readonly width: number;
  readonly height: number;
  /** RGB radiance, top row first. */
  readonly image: Float32Array;
  /** Standard error of every value of `image`. */
  readonly standardError: Float32Array;
};

export const REFERENCE_NAMES = ["cornell", "spheres", "bleed", "veach", "furnace"] as const;

export function loadReference(name: (typeof REFERENCE_NAMES)[number]): Reference {
  const { width, height } = JSON.parse(readText(`${name}.meta.json`)) as { width: number; height: number };
  return {
    scene: JSON.parse(readText(`scenes/${name}.json`)) as Scene,
    width,
    height,
    image: readFloats(`${name}.f32`),
    standardError: readFloats(`${name}.se.f32`),
  };
}

function readText(file: string): string {
  return readFileSync(new URL(file, FOLDER), "utf8");
}

function readFloats(file: string): Float32Array {
  const bytes = readFileSync(new URL(file, FOLDER));
  return new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
}
