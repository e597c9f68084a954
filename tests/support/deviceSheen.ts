import { runProbe } from "./probe";

// Multiples of the columns of the table.
const STEPS = 15 * 16;

/** The shader's `sheenAlbedo` of cosines and roughnesses. */
export async function deviceSheenAlbedo(pairs: readonly (readonly [cosine: number, roughness: number])[]) {
  const words = await runProbe({
    wgsl: `
      import package::lobes::sheen::sheenAlbedo;
      fn probe(i: u32) {
        let input = bitcast<vec4f>(inputs[i]);
        outputs[i].x = bitcast<u32>(sheenAlbedo(input.x, input.y));
      }`,
    conditions: { SHEEN: true },
    modules: { scene: "struct Bsdf { a: f32 }" },
    count: pairs.length,
    inputs: new Float32Array(pairs.flatMap(([cosine, roughness]) => [cosine, roughness, 0, 0])),
    outputRows: pairs.length,
  });
  return Float64Array.from(pairs, (_, i) => new Float32Array(words.buffer)[4 * i]!);
}

/** The same as functions of the cosine, a roughness each, for oracles that take it as given. */
export async function sheenAlbedoOf(roughnesses: readonly number[]): Promise<((cosine: number) => number)[]> {
  const values = await deviceSheenAlbedo(
    roughnesses.flatMap((roughness) =>
      Array.from({ length: STEPS + 1 }, (_, i) => [(i / STEPS) ** 3, roughness] as const),
    ),
  );
  return roughnesses.map((_, row) => (cosine) => {
    const column = Math.cbrt(cosine) * STEPS;
    const i = Math.min(Math.floor(column), STEPS - 1);
    const at = row * (STEPS + 1) + i;
    return values[at]! + (column - i) * (values[at + 1]! - values[at]!);
  });
}
