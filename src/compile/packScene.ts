import type { Ball, Light } from "../lights/light";
import { tagOf } from "../lights/lights";
import type { ResolvedScene } from "../scene/schema";
import type { Vec4 } from "../shapes/shape";
import { kindOf } from "../shapes/shapes";
import type { Geometry } from "../tree/geometry";
import { hasManyLights } from "./emitLights";
import { unboundedRows } from "./emitLoops";
import { factorsLayout, rareTextures } from "./factors";
import type { Features } from "./features";
import { PLACED_TEXTURE, TEXTURE } from "./layouts";
import { materialTable } from "./materialTable";
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
  { environment, textures }: ResolvedScene,
  features: Features,
) {
  const isMany = hasManyLights(lights);
  return {
    environment: environment.radiance,
    materials: materialTable(primitives, lights, features),
    shapes: primitives.map(({ shape }) => kindOf(shape).row(shape)),
    anchors: anchorRows(primitives, features),
    lights: lightRows(primitives, lights, geometry),
    ...lightBoundRows(isMany ? lights : [], primitives),
    unbounded: unboundedRows(unrolling, primitives),
    ofTextures:
      features.VERTICES && geometry
        ? {
            ...geometry.textureTables(
              textures,
              primitives.map(({ material }) => material),
            ),
            layout: features.UV_TRANSFORMS ? PLACED_TEXTURE : TEXTURE,
            factorsLayout: factorsLayout(rareTextures(primitives)),
          }
        : undefined, // nobody may use them
  };
}

/** One per primitive, or none where the shader reads none. */
function anchorRows(primitives: readonly Primitive[], { RIMS, HUGE_BALLS }: Features): readonly Vec4[] {
  return RIMS || HUGE_BALLS ? primitives.map(({ shape }) => kindOf(shape).anchor(shape)) : [];
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
