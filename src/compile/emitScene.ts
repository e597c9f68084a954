// @lean wgsl
// Writes the shader module `scene`: the scene's own intersection functions, unrolled, and access to its tables.
// Numbers come from validated scenes only and names from this file; no user text reaches WGSL.

import type { Light } from "../lights/light";
import type { Geometry } from "../tree/geometry";
import { emitStruct, type StructFields, type StructLayout } from "./defineStruct";
import { emitLightChoice, emitLightSamplers, emitSkyLights } from "./emitLights";
import { emitLobes } from "./emitLobes";
import { emitRowStruct } from "./emitLoops";
import { emitShapes } from "./emitShapes";
import { rareTextures } from "./factors";
import type { Features } from "./features";
import { LIGHT } from "./layouts";
import type { Tables } from "./packScene";
import type { Primitive } from "./primitives";
import { emitMembers, type Member } from "./sceneMembers";
import type { Unrolling } from "./unrolling";
import type { Row, RowType, Values } from "./values";

/** What a scene is made of, as the shader sees it. */
export type SceneParts = {
  readonly primitives: readonly Primitive[];
  readonly lights: readonly Light[];
  readonly unrolling: Unrolling;
  readonly features: Features;
  readonly tables: Tables;
  readonly geometry: Geometry | undefined;
};

/**
 * The text of module `scene`.
 *
 * @param values - how numbers are named.
 * @param blocks - whether primitive `id` can come between a shaded point and a light.
 * @param packed - asked once all numbers are named: the members of `scene`, and whether they are in a storage buffer, being too
 * many for a uniform.
 */
export function emitScene(
  { primitives, lights, unrolling, features, tables, geometry }: SceneParts,
  values: Values,
  blocks: (id: number) => boolean,
  packed: () => { readonly members: readonly Member[]; readonly isStored: boolean },
): string {
  const shapes = emitShapes(primitives, lights, unrolling, geometry, values, blocks);
  const lightChoice = emitLightChoice(lights, features, values);
  const { members, isStored } = packed();

  return `
import package::lights::light::{Light, LightChoice, LightSample, flatLightShare, lightShare, skyLightShare};
import package::lobes::lobe::{BsdfSample, BsdfValue, aboveOnly, directions, exactDirections, onSides, uniformSample, weighed};
import package::minMax::{greater, lesser};
import package::coverage::{betweenPart, entersPart, nearerPart};
import package::ray::{Hit, Ray, between, innerRay, nearer, noHit};
import package::surface::Surface;
import package::textures::Texture;
import package::shapes::triangle::{Shear, shearOf};
import package::tree::{Item, itemAt, treeClosest, treeOccludes};

// Ids from here on are those of items of the tree, by their slot.
const PRIMITIVES = ${primitives.length}u;
const STACK_SIZE = ${stackSizeFor(geometry)}u;
${emitRowStruct(unrolling)}
${emitStruct("Material", tables.materials.layout)}
${emitMembers(members)}
// Written by the renderer when the scene changes.
@group(0) @binding(1) var<${isStored ? "storage, read" : "uniform"}> scene: Scene;
${shapes}
fn environment() -> vec3f {
  return scene.environment[0].rgb;
}
${tables.ofTextures ? `${emitFactors(tables.ofTextures)}${TEXTURE_LOOKUPS}` : ""}${emitVertexLayout(features, geometry)}
${emitLookups(tables, values)}
${emitLobes(features, rareTextures(primitives))}${emitLightSamplers(lights, features)}${emitSkyLights(lights, features)}
${lightChoice}`;
}

// The stack grows in steps, so that most geometry shares a program. One place more than links can wait.
const STACK_STEP = 8;

function stackSizeFor(geometry: Geometry | undefined): number {
  return Math.max(Math.ceil((geometry ? geometry.depth + 1 : 0) / STACK_STEP), 1) * STACK_STEP;
}

/** Where the parts of a vertex are, in pairs of f32; see `VertexLayout`. */
function emitVertexLayout({ UV_TRANSFORMS }: Features, geometry: Geometry | undefined): string {
  if (!geometry) return "";
  const { stride, colors = 0, tangents = 0, uvs1 = 0 } = geometry.vertexLayout;
  const second = UV_TRANSFORMS ? `const UVS1_AT = ${uvs1}u;\n` : "";
  return `const VERTEX_STRIDE = ${stride}u;\nconst COLOR_AT = ${colors}u;\nconst TANGENT_AT = ${tangents}u;\n${second}`;
}

/** The struct of a row: see `factors.ts`. */
function emitFactors({ factorsLayout }: NonNullable<Tables["ofTextures"]>): string {
  return `
// What the textures of a primitive multiply, and which they are: NONE for none.
${emitStruct("Factors", factorsLayout)}`;
}

const TEXTURE_LOOKUPS = `
fn factorsOf(i: u32) -> Factors {
  return scene.factors[i];
}

// The texture whose alpha says where a primitive is.
fn coverTextureOf(i: u32) -> u32 {
  return scene.factors[i].baseColorTexture;
}

fn textureOf(i: u32) -> Texture {
  return scene.textures[i];
}
`;

/**
 * Functions that look values up: `shapeOf(id)`; per field of a material `alphaOf(id)` and so on; per field of a light
 * `lightSize(index)` and so on, and `lightAt(index)`. The linker drops those that the features leave unused.
 */
function emitLookups({ materials, shapes, anchors, lights }: Tables, values: Values): string {
  const lookup = <R>(name: string, type: RowType, uniform: string, rows: readonly R[], fieldOf: (row: R) => Row) =>
    `fn ${name}(i: u32) -> ${type} {\n${values.lookup(uniform, type, rows.length, (i) => fieldOf(rows[i]!))}}\n`;
  const lightFields = fieldsOf(LIGHT).map(([field]) => `${lightField(field)}(i)`);
  return [
    lookup("shapeOf", "vec4f", "scene.shapes[i]", shapes, (row) => row),
    lookup("anchorOf", "vec4f", "scene.anchors[i]", anchors, (row) => row),
    ...fieldsOf(materials.layout).map(([field, type]) =>
      lookup(`${field}Of`, type, `scene.materials[i].${field}`, materials.rows, (row) => row[field]!),
    ),
    ...fieldsOf(LIGHT).map(([field, type]) =>
      lookup(lightField(field), type, `scene.lights[i].${field}`, lights, (row) => row[field]),
    ),
    `fn lightAt(i: u32) -> Light {\n  return Light(${lightFields.join(", ")});\n}\n`,
  ].join("\n");
}

/** Fields and types of a table's struct, in order. */
function fieldsOf<F extends StructFields>({ fields }: StructLayout<F>): [keyof F & string, RowType][] {
  return Object.entries(fields) as [keyof F & string, RowType][];
}

function lightField(field: string): string {
  return `light${field[0]!.toUpperCase()}${field.slice(1)}`;
}
