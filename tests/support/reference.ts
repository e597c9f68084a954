import { readFileSync } from "node:fs";
import { loadGltf } from "../../src/loaders/gltf";
import type { Scene } from "../../src/scene/schema";

const FOLDER = new URL("../reference/", import.meta.url);

/** A converged image of a reference scene, made by Mitsuba or Cycles. */
export type Reference = {
  readonly scene: Scene;
  readonly width: number;
  readonly height: number;
  /** RGB radiance, top row first. */
  readonly image: Float32Array;
  /** Standard error of every value of `image`. */
  readonly standardError: Float32Array;
  /** Per pixel. */
  readonly samples: number;
  /** How far every value of `image` may be off for reasons that are no noise, as a share of it. */
  readonly bias: Float64Array;
};

/** Of spheres, boxes and the like. */
export const ANALYTIC_NAMES = ["cornell", "spheres", "bleed", "veach", "furnace"] as const;
export const REFERENCE_NAMES = [...ANALYTIC_NAMES, "knot", "glow"] as const;
/** Of surfaces that light passes, or that have pictures on them. */
export const SURFACE_REFERENCE_NAMES = ["glass", "cutouts", "textured"] as const;

type ReferenceName = (typeof REFERENCE_NAMES)[number] | (typeof SURFACE_REFERENCE_NAMES)[number];

type Meta = { readonly width: number; readonly height: number; readonly spp: number };

// Mitsuba adds up its samples in f32 too: the sky of `spheres`, a constant, is off by 2.6e-5 in its image.
const ROUNDING_BIAS = 3e-5;

// Where the references are known to be wrong, and by how much.
const KNOWN_BIAS: { readonly [name: string]: (x: number, y: number) => number } = {
  // Mitsuba's planes end 10⁴ from their point, 1.6e-4 rad below the horizon of a camera 1.6 above it: 3 % of the height
  // of a pixel row of 40°/128. It shows sky there, ours the floor, and they differ by at most a half.
  spheres: (_, y) => (y === 28 ? 0.016 : 0),
  // The reference's GGX density has cos²·(α² − 1) + 1 in f32, whose cancellation costs 1.2e-7 of α² = 6e-6, 2 %, in the
  // first sphere. Its square in a denominator is biased: the sphere loses 0.14 % of its light, and up to half a per cent
  // at its edge. By the integral in doubles it loses less than 1e-5; `directionalAlbedo.test.ts` holds ours to that.
  furnace: (x, y) => ((x - 13) ** 2 + (y - 47) ** 2 < 17 ** 2 ? 0.005 : 0),
};

export function loadReference(name: ReferenceName): Reference {
  return { scene: JSON.parse(readText(`scenes/${name}.json`)) as Scene, ...loadImage(name) };
}

/** Of `mirrored`, which is a glTF file: rendered by Cycles as Blender imports it, and loaded as we do. */
export async function loadGltfReference(): Promise<Reference> {
  const { scene } = await loadGltf(readFileSync(new URL("mirrored.glb", FOLDER)));
  return { scene, ...loadImage("mirrored") };
}

function loadImage(name: string): Omit<Reference, "scene"> {
  const { width, height, spp } = JSON.parse(readText(`${name}.meta.json`)) as Meta;
  return {
    width,
    height,
    image: readFloats(`${name}.f32`),
    standardError: readFloats(`${name}.se.f32`),
    samples: spp,
    bias: Float64Array.from({ length: 3 * width * height }, (_, i) => {
      const pixel = Math.floor(i / 3);
      return ROUNDING_BIAS + (KNOWN_BIAS[name]?.(pixel % width, Math.floor(pixel / width)) ?? 0);
    }),
  };
}

function readText(file: string): string {
  return readFileSync(new URL(file, FOLDER), "utf8");
}

function readFloats(file: string): Float32Array {
  const bytes = readFileSync(new URL(file, FOLDER));
  return new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
}
