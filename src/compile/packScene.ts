import type { Ball, Light } from "../lights/light";
import { samplerOf, tagOf } from "../lights/lights";
import { reflectance } from "../lobes/lobes";
import type { Rgb } from "../scene/schema";
import type { Vec4 } from "../shapes/shape";
import { kindOf } from "../shapes/shapes";
import type { Geometry } from "../tree/geometry";
import type { Textures } from "../tree/packTexels";
import { hasManyLights } from "./emitLights";
import { unboundedRows } from "./emitLoops";
import { hasHugeBalls, hasRims } from "./features";
import type { Primitive } from "./primitives";
import type { Unrolling } from "./unrolling";

const NO_PRIMITIVE = 0xffffffff;

/** What the shader looks up by number, and the environment. */
export type Tables = ReturnType<typeof tablesOf>;

export function tablesOf(
  primitives: readonly Primitive[],
  lights: readonly Light[],
  unrolling: Unrolling,
  geometry: Geometry | undefined,
  environment: Rgb,
  textures: Textures | undefined,
) {
  const isMany = hasManyLights(lights);
  return {
    environment,
    materials: materialRows(primitives, lights),
    shapes: primitives.map(({ shape }) => kindOf(shape).row(shape)),
    anchors: anchorRows(primitives),
    lights: lightRows(primitives, lights, geometry),
    ...lightBoundRows(isMany ? lights : [], primitives),
    unbounded: unboundedRows(unrolling, primitives),
    ofTextures:
      textures &&
      geometry?.textureTables(
        textures,
        primitives.map(({ material }) => material),
      ),
  };
}

/** The surfaces of all primitives, by id. Those of a material that are no lights share a row. */
function materialRows(primitives: readonly Primitive[], lights: readonly Light[]) {
  const densities = lightDensities(lights);
  const dark = new Map<Primitive["material"], ReturnType<typeof materialRow>>();
  return primitives.map((primitive, id) => {
    const density = densities.get(id);
    if (density !== undefined) return materialRow(primitive, density);
    const row = dark.get(primitive.material) ?? materialRow(primitive, 0);
    dark.set(primitive.material, row);
    return row;
  });
}

function materialRow({ material, emission }: Primitive, lightDensity: number) {
  return { ...reflectance(material), emission, lightDensity };
}

/** By primitive that emits; see `Material` in `wgsl/surface.wgsl`. */
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

/** One per primitive, or none where the shader reads none: see features. */
function anchorRows(primitives: readonly Primitive[]): readonly Vec4[] {
  const isRead = hasRims(primitives) || hasHugeBalls(primitives);
  return isRead ? primitives.map(({ shape }) => kindOf(shape).anchor(shape)) : [];
}

/** The lights, as the shader's table wants them. */
function lightRows(primitives: readonly Primitive[], lights: readonly Light[], geometry: Geometry | undefined) {
  return lights.map((light) => {
    const { position, size, edge1, edge2, normal, radiance } = light;
    const id = hitId(light.primitive, primitives, geometry);
    return { position, size, edge1, edge2, normal, radiance, kind: tagOf(light), id };
  });
}

/** What a ray that hits a primitive names; of a mesh it names the triangle. */
function hitId(id: number | undefined, primitives: readonly Primitive[], geometry: Geometry | undefined): number {
  if (id === undefined || kindOf(primitives[id]!.shape).triangleDistance) return NO_PRIMITIVE;
  const slot = geometry?.shapes.get(id);
  return slot === undefined ? id : primitives.length + slot;
}

/** What the choice among many lights looks up: see `emitLights.ts`. */
function lightBoundRows(lights: readonly Light[], primitives: readonly Primitive[]) {
  const byPrimitive = new Map(lights.map(({ primitive, bound }) => [primitive, bound]));
  const row = (bound: Ball | undefined) => (bound ? [...bound.center, bound.radius] : [0, 0, 0, 0]);
  return {
    lightBounds: lights.map(({ bound }) => row(bound)),
    lightFronts: lights.map(({ front = [0, 0, 0], strength }) => [...front, strength]),
    primitiveBounds: lights.length > 0 ? primitives.map((_, id) => row(byPrimitive.get(id))) : [],
  };
}
