// The table of materials, a row per primitive: `Material` in the generated module.

import type { Light } from "../lights/light";
import { samplerOf } from "../lights/lights";
import { rowOf, tableColumns } from "../lobes/lobes";
import { defineStruct, type StructFields, type StructLayout, type StructValue } from "./defineStruct";
import type { Features } from "./features";
import type { Primitive } from "./primitives";

export type MaterialTable = {
  readonly layout: StructLayout<StructFields>;
  /** Primitives of a material that are no lights share a row. */
  readonly rows: readonly StructValue<StructFields>[];
};

/** The columns of the scene's lobes and, if something emits, radiance and density. */
export function materialTable(
  primitives: readonly Primitive[],
  lights: readonly Light[],
  features: Features,
): MaterialTable {
  const columns = tableColumns(features);
  const emitting = features.EMISSION ? ({ emission: "vec3f", lightDensity: "f32" } as const) : {};
  const fields = { ...Object.fromEntries(columns.map(([name, { type }]) => [name, type])), ...emitting };
  const densities = lightDensities(lights);
  const rowFor = ({ material, emission }: Primitive, lightDensity: number) => ({
    ...rowOf(material, columns),
    emission,
    lightDensity,
  });
  const dark = new Map<Primitive["material"], ReturnType<typeof rowFor>>();
  const rows = primitives.map((primitive, id) => {
    const density = densities.get(id);
    if (density !== undefined) return rowFor(primitive, density);
    const row = dark.get(primitive.material) ?? rowFor(primitive, 0);
    dark.set(primitive.material, row);
    return row;
  });
  return { layout: defineStruct(packed(fields)), rows };
}

/** In an order that leaves no gaps: each vector is followed by a scalar. */
function packed(fields: StructFields): StructFields {
  const [vectors, scalars] = [true, false].map((isVector) =>
    Object.entries(fields).filter(([, type]) => (type === "vec3f") === isVector),
  );
  const pairs = vectors!.flatMap((vector, i) => (scalars![i] ? [vector, scalars![i]] : [vector]));
  return Object.fromEntries([...pairs, ...scalars!.slice(vectors!.length)]);
}

/**
 * By primitive that emits: the density of light sampling, per area on flat emitters, 1 on spheres. Where there are many lights, times the
 * light's strength: to be multiplied by lightShareOf() and divided by the weight of all lights.
 */
function lightDensities(lights: readonly Light[]): ReadonlyMap<number, number> {
  const sums = new Map<number, { weight: number; size: number; isCone: boolean }>();
  for (const light of lights) {
    const { primitive, strength, size } = light;
    if (primitive === undefined) continue;
    const sum = sums.get(primitive) ?? { weight: 0, size: 0 };
    const isCone = samplerOf(light).measure === "cone";
    sums.set(primitive, { weight: sum.weight + strength, size: sum.size + size, isCone });
  }
  const isAlone = lights.length === 1;
  return new Map(
    Array.from(sums, ([id, { weight, size, isCone }]) => {
      const share = isAlone ? 1 : weight;
      return [id, isCone ? share : share / size];
    }),
  );
}
