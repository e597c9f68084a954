import type { Scene } from "rt-viewer";

/** A scene whose true picture is known: made by Mitsuba, and served next to this page. */
export type Reference = {
  readonly name: string;
  readonly scene: Scene;
  readonly width: number;
  readonly height: number;
  /** RGB radiance, top row first. */
  readonly image: Float32Array;
  /** Behind `image`, per pixel. */
  readonly samples: number;
  /** Mean over all pixels and channels. */
  readonly mean: number;
  /** Mean squared standard error of `image`. */
  readonly meanSquaredNoise: number;
  /** The relative RMSE of `image` itself: no smaller error can be told with it. */
  readonly ownError: number;
};

type Meta = { readonly width: number; readonly height: number; readonly spp: number };

/** @throws {Error} naming the file that could not be loaded. */
export async function loadReference(name: string): Promise<Reference> {
  const [scene, meta, image, standardError] = await Promise.all([
    load(`scenes/${name}.json`).then((response) => response.json() as Promise<Scene>),
    load(`references/${name}.meta.json`).then((response) => response.json() as Promise<Meta>),
    load(`references/${name}.f32`).then(readFloats),
    load(`references/${name}.se.f32`).then(readFloats),
  ]);
  const mean = image.reduce((sum, value) => sum + value, 0) / image.length;
  const meanSquaredNoise = standardError.reduce((sum, value) => sum + value * value, 0) / standardError.length;
  const { width, height, spp: samples } = meta;
  const ownError = Math.sqrt(meanSquaredNoise) / mean;
  return { name, scene, width, height, image, samples, mean, meanSquaredNoise, ownError };
}

async function load(path: string): Promise<Response> {
  const response = await fetch(path);
  if (!response.ok) throw new Error(`${path} could not be loaded: ${response.status} ${response.statusText}`);
  return response;
}

/** The files are little-endian, as is every machine with a browser. */
async function readFloats(response: Response): Promise<Float32Array> {
  return new Float32Array(await response.arrayBuffer());
}
