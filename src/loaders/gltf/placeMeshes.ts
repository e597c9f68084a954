// Meshes in all their places, as objects of a scene.

import type { Accessor } from "@gltf-transform/core";
import { mat4d } from "wgpu-matrix";
import { LoadError } from "../../errors";
import { mesh } from "../../scene/builders";
import type { SceneObject } from "../../scene/schema";
import { Bounds } from "../bounds";
import { MAX_DISTANCE, MAX_OBJECTS, MAX_TRIANGLES, MAX_VERTICES } from "../limits";
import type { Materials } from "./materials";
import { checkReach, compose, type PlacedNode } from "./nodes";
import { hasTriangles, readTriangles, type Triangles, VertexData } from "./primitive";
import type { GltfJson } from "./schema";
import { transformUvs } from "./textureCoordinates";
import { flipWinding, isIdentity, isMirror, transformNormals, transformPositions } from "./transform";

/** A primitive as it is in all its places, and what may be shared between them. */
type Shape = {
  readonly triangles: Triangles;
  readonly material: string;
  readonly uvs?: Float32Array;
  flipped?: Uint32Array;
};

/** Places meshes in the world. */
export class MeshPlacer {
  readonly objects: SceneObject[] = [];
  readonly bounds = new Bounds();
  readonly #json: GltfJson;
  readonly #data: VertexData;
  readonly #materials: Materials;
  /** By mesh. */
  readonly #shapes = new Map<number, readonly Shape[]>();
  readonly #read = new Tally();
  readonly #placed = new Tally();

  constructor(json: GltfJson, accessors: readonly Accessor[], materials: Materials) {
    this.#json = json;
    this.#data = new VertexData(accessors);
    this.#materials = materials;
  }

  /** @throws {LoadError} if that makes too many triangles. */
  place({ index, node, world }: PlacedNode): void {
    if (node.mesh === undefined) return;
    const shapes = this.#shapesOf(node.mesh);
    if (shapes.length === 0) return; // in however many places
    const instances = node.extensions?.EXT_mesh_gpu_instancing?.attributes;
    const path = `nodes[${index}]`;
    const places = instances === undefined ? [world] : instanceMatrices(instances, this.#data, world, path);
    for (const place of places) this.#add(shapes, place);
  }

  #shapesOf(mesh: number): readonly Shape[] {
    const known = this.#shapes.get(mesh);
    if (known !== undefined) return known;
    const shapes: Shape[] = [];
    this.#json.meshes[mesh]!.primitives.forEach((primitive, i) => {
      if (!hasTriangles(primitive)) return;
      // Shared data is counted each time, because work and memory are spent on it each time.
      const { indices = primitive.attributes.POSITION } = primitive;
      this.#read.add(indices === undefined ? 0 : this.#data.at(indices).getCount() / 3, 0);
      const triangles = readTriangles(primitive, this.#data, `meshes[${mesh}].primitives[${i}]`);
      if (triangles === undefined) return;
      this.#read.add(0, triangles.positions.length / 3);
      const { name, coordinates } = this.#materials.choose(primitive.material, triangles.uvs);
      const uvs = coordinates && transformUvs(triangles.uvs.get(coordinates.set)!, coordinates);
      shapes.push({ triangles, material: name, ...(uvs && { uvs }) });
    });
    this.#shapes.set(mesh, shapes);
    return shapes;
  }

  #add(shapes: readonly Shape[], world: Float64Array): void {
    for (const shape of shapes) {
      const { positions, normals, indices } = shape.triangles;
      this.#placed.add(indices.length / 3, positions.length / 3);
      if (this.objects.length === MAX_OBJECTS)
        throw new LoadError(`has more than ${MAX_OBJECTS} meshes, in all places`);
      const isInPlace = isIdentity(world);
      const placed = isInPlace ? positions : transformPositions(positions, world);
      this.bounds.add(placed);
      if (this.bounds.reach > MAX_DISTANCE) throw new LoadError(`has a vertex ${this.bounds.reach} m from the origin`);
      if (isMirror(world)) shape.flipped ??= flipWinding(indices);
      this.objects.push(
        mesh({
          positions: placed,
          indices: isMirror(world) ? shape.flipped! : indices,
          ...(normals && { normals: isInPlace ? normals : transformNormals(normals, world) }),
          ...(shape.uvs && { uvs: shape.uvs }),
          material: shape.material,
        }),
      );
    }
  }
}

/** Counts up to what is allowed. */
class Tally {
  #triangles = 0;
  #vertices = 0;

  add(triangles: number, vertices: number): void {
    this.#triangles += triangles;
    this.#vertices += vertices;
    if (this.#triangles > MAX_TRIANGLES) throw new LoadError(`has more than ${MAX_TRIANGLES} triangles`);
    if (this.#vertices > MAX_VERTICES) throw new LoadError(`has more than ${MAX_VERTICES} vertices`);
  }
}

function* instanceMatrices(
  attributes: Readonly<Record<string, number>>,
  data: VertexData,
  world: Float64Array,
  path: string,
): Generator<Float64Array> {
  const counts = new Set(Object.values(attributes).map((index) => data.at(index).getCount()));
  if (counts.size > 1) throw new LoadError(`${path}: EXT_mesh_gpu_instancing has attributes of different lengths`);
  const read = (semantic: string, i: number, initial: number[]) =>
    attributes[semantic] === undefined ? initial : data.at(attributes[semantic]).getElement(i, [...initial]);
  const [count = 0] = counts;
  for (let i = 0; i < count; i++) {
    const scale = read("SCALE", i, [1, 1, 1]);
    const local = compose(read("TRANSLATION", i, [0, 0, 0]), read("ROTATION", i, [0, 0, 0, 1]), scale);
    yield checkReach(mat4d.multiply(world, local), `${path}, instance ${i}`);
  }
}
