// What is too much to be unrolled into the program, in a tree: the triangles of meshes, and shapes where there are many. Pure;
// the renderer puts it on the GPU.

import { type AsyncBuildOptions, buildBvhAsync } from "../bvh/buildInWorker";
import { triangleBounds } from "../bvh/triangleBounds";
import { length, subtract } from "../math/vec3";
import type { ResolvedScene, Vec3 } from "../scene/schema";
import { emissionOf } from "../scene/shown";
import { inSceneUnits } from "../shapes/sceneUnits";
import { isMesh, itemOf, type MeshObject } from "../shapes/shapes";
import type { BoundedPrimitive } from "./boundedShapes";
import { boundsOfShape } from "./boundsOfShape";
import type { MeshPart } from "./meshPart";
import { packItems } from "./packItems";
import { type MeshLight, packMeshLights } from "./packMeshLights";
import { haveSameTexels, type Textures, texelParts } from "./packTexels";
import { packTree } from "./packTree";
import { textureTables } from "./textureTables";
import { treeShapesOf } from "./treeShapes";
import { type VertexLayout, vertexLayoutOf } from "./vertexLayout";

// Triangles in a leaf of the tree, at most. The shader was as quick with 4 for 1,000 triangles, and 10 % slower for 100,000.
const MAX_LEAF = 2;

/** What `wgsl/tree.wgsl`, `wgsl/textures.wgsl`, `shapes/mesh.wgsl` and `lights/mesh.wgsl` read. */
export type GeometryData = {
  readonly nodes: ArrayBuffer;
  readonly items: ArrayBuffer;
  /** Undefined where no mesh has normals. */
  readonly normals: ArrayBuffer | undefined;
  /** Undefined where no mesh emits. */
  readonly emissiveTriangles: ArrayBuffer | undefined;
  /** Undefined where no material has textures, and no mesh colours. */
  readonly vertices: ArrayBuffer | undefined;
  /** One after the other. */
  readonly texels: readonly Uint8Array[] | undefined;
};

export type Geometry = {
  /** The scene's point that is the shader's origin. */
  readonly origin: Vec3;
  readonly parts: readonly MeshPart[];
  /** Ids of those that emit, and, of those of them that have an area, where their triangles stand. */
  readonly emitting: readonly number[];
  readonly lights: ReadonlyMap<number, MeshLight>;
  readonly textures: Textures;
  /** What packs those, because only a scene of meshes has some. */
  readonly textureTables: typeof textureTables;
  /** `slotOf[item]`: where it lies in the tree's leaves. Items are the triangles of all meshes, then `treeShapes`. */
  readonly slotOf: Uint32Array;
  readonly treeShapes: readonly BoundedPrimitive[];
  /** Slots of those, by the ids of their primitives. */
  readonly shapes: ReadonlyMap<number, number>;
  /** What the vertices of triangles have. */
  readonly vertexLayout: VertexLayout;
  /** Levels of the tree below its root: as many links may wait while a ray is traced. */
  readonly depth: number;
  readonly data: GeometryData;
};

export type GeometryOptions = Pick<AsyncBuildOptions, "signal" | "onProgress"> & {
  /** Returned as it is if nothing has changed that it depends on. */
  readonly previous?: Geometry | undefined;
};

/**
 * Sorts what is not unrolled into a tree, in a worker if it is much.
 *
 * @returns undefined for a scene that has no such thing.
 * @throws the reason of `signal`.
 */
export async function prepareGeometry(
  given: ResolvedScene,
  { previous, ...options }: GeometryOptions = {},
): Promise<Geometry | undefined> {
  const { scene } = inSceneUnits(given);
  const origin = scene.camera.target;
  const meshes = meshesOf(scene);
  const treeShapes = treeShapesOf(scene);
  if (meshes.length + treeShapes.length === 0) return undefined;
  const emits = (object: MeshObject) => emissionOf(scene.materials[object.material]!).some((value) => value > 0);
  const emitting = meshes.flatMap(({ object, id }) => (emits(object) ? [id] : []));
  const usesUvs =
    Object.keys(scene.textures).length > 0 || Object.values(scene.materials).some(({ anisotropy }) => anisotropy > 0);
  const hasLayout = (previous?.vertexLayout.uvs !== undefined) === usesUvs;
  if (
    previous &&
    hasLayout &&
    isSame(previous, meshes, treeShapes, origin) &&
    haveSameTexels(previous.textures, scene.textures)
  ) {
    return areEqual(emitting, previous.emitting) ? previous : withLights(previous, emitting);
  }

  let triangleCount = 0;
  const parts = meshes.map(({ object, id }): MeshPart => {
    const positions = relative(object.positions, origin);
    const firstTriangle = triangleCount;
    triangleCount += object.indices.length / 3;
    return { object, id, positions, firstTriangle, ...boundsOf(positions) };
  });
  const bounds = new Float32Array(6 * (triangleCount + treeShapes.length));
  for (const { object, positions, firstTriangle } of parts) {
    bounds.set(triangleBounds(positions, object.indices), 6 * firstTriangle);
  }
  for (const [i, { shape }] of treeShapes.entries()) bounds.set(boundsOfShape(shape), 6 * (triangleCount + i));
  const bvh = await buildBvhAsync(bounds, { maxLeaf: MAX_LEAF, ...options });
  const slotOf = new Uint32Array(bvh.order.length);
  for (let slot = 0; slot < bvh.order.length; slot++) slotOf[bvh.order[slot]!] = slot;
  const shapes = new Map(treeShapes.map(({ id }, i) => [id, slotOf[triangleCount + i]!]));
  const { textures } = scene;
  const texels = texelParts(textures);
  const vertexLayout = vertexLayoutOf(parts, usesUvs);
  const data = { nodes: packTree(bvh), ...packItems(parts, treeShapes, slotOf, vertexLayout), texels };
  const { depth } = bvh;
  return withLights(
    { origin, parts, treeShapes, shapes, textures, textureTables, slotOf, depth, vertexLayout, data },
    emitting,
  );
}

function meshesOf(scene: ResolvedScene): { object: MeshObject; id: number }[] {
  return scene.objects.flatMap((object, id) => (isMesh(object) ? [{ object, id }] : []));
}

type Unlit = Omit<Geometry, "emitting" | "lights" | "data"> & {
  readonly data: Omit<GeometryData, "emissiveTriangles">;
};

function withLights(geometry: Unlit, emitting: readonly number[]): Geometry {
  const ids = new Set(emitting);
  const shining = geometry.parts.filter(({ id }) => ids.has(id));
  const { lights, table } = packMeshLights(shining, geometry.slotOf);
  return { ...geometry, emitting, lights, data: { ...geometry.data, emissiveTriangles: table } };
}

function relative(positions: Float64Array, [x, y, z]: Vec3): Float32Array {
  const result = new Float32Array(positions.length);
  for (let i = 0; i < positions.length; i += 3) {
    result[i] = positions[i]! - x;
    result[i + 1] = positions[i + 1]! - y;
    result[i + 2] = positions[i + 2]! - z;
  }
  return result;
}

function boundsOf(positions: Float32Array): { lower: Vec3; upper: Vec3 } {
  const lower: [number, number, number] = [0, 0, 0];
  const upper: [number, number, number] = [0, 0, 0];
  for (const axis of [0, 1, 2] as const) {
    let [least, most] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
    for (let i = axis; i < positions.length; i += 3) {
      least = Math.min(least, positions[i]!);
      most = Math.max(most, positions[i]!);
    }
    if (least > most) continue; // no vertices
    lower[axis] = least;
    upper[axis] = most;
  }
  return { lower, upper };
}

function isSame(
  { parts, treeShapes: shapesBefore, origin: before }: Geometry,
  meshes: readonly { object: MeshObject; id: number }[],
  treeShapes: readonly BoundedPrimitive[],
  origin: Vec3,
): boolean {
  const hasMoved = length(subtract(origin, before)) > 0;
  if (hasMoved || parts.length !== meshes.length) return false;
  if (treeShapes.length !== shapesBefore.length) return false;
  if (!treeShapes.every((shape, i) => isSameItem(shape, shapesBefore[i]!))) return false;
  return parts.every((part, i) => {
    const { object, id } = meshes[i]!;
    return id === part.id && GEOMETRY_FIELDS.every((field) => areEqual(object[field], part.object[field]));
  });
}

/** Whether two primitives are the same item of a tree. */
function isSameItem(a: BoundedPrimitive, b: BoundedPrimitive): boolean {
  if (a.id !== b.id || a.shape.kind !== b.shape.kind) return false;
  const [item, before] = [itemOf(a.shape), itemOf(b.shape)];
  return item.w === before.w && item.vectors.every((vector, i) => areEqual(vector, before.vectors[i]!));
}

const GEOMETRY_FIELDS = ["positions", "indices", "normals", "uvs", "uvs1", "colors", "tangents"] as const;

function areEqual(a: ArrayLike<number> | undefined, b: ArrayLike<number> | undefined): boolean {
  if (a === b) return true;
  if (a === undefined || b === undefined || a.length !== b.length) return false;
  for (let i = 0; i < a.length; i++) if (a[i] !== b[i]) return false;
  return true;
}
