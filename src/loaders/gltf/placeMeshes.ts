// Meshes in all their places, as objects of a scene.

import type { Accessor } from "@gltf-transform/core";
import { mat4d } from "wgpu-matrix";
import { LoadError } from "../../errors";
import { mesh } from "../../scene/builders";
import type { Mesh } from "../../scene/meshes";
import type { SceneObject } from "../../scene/schema";
import { Bounds } from "../bounds";
import { MAX_DISTANCE, MAX_OBJECTS, MAX_TRIANGLES, MAX_VERTICES } from "../limits";
import type { Warnings } from "../warnings";
import { type Materials, placeOf } from "./materials";
import { compose, isWithinReach, type PlacedNode } from "./nodes";
import { hasTriangles, readTriangles, type Triangles, VertexData } from "./primitive";
import type { GltfJson, GltfPrimitive } from "./schema";
import {
  flipWinding,
  hasNoArea,
  isIdentity,
  isMirror,
  reachOf,
  transformNormals,
  transformPositions,
  transformTangents,
} from "./transform";

/** A primitive as it is in all its places, and what may be shared between them. */
type Shape = {
  readonly triangles: Triangles;
  readonly material: string;
  readonly uvs: Pick<Mesh, "uvs" | "uvs1">;
  flipped?: Uint32Array;
};

/** Places meshes in the world. */
export class MeshPlacer {
  readonly objects: SceneObject[] = [];
  readonly bounds = new Bounds();
  readonly #json: GltfJson;
  readonly #data: VertexData;
  readonly #materials: Materials;
  readonly #warnings: Warnings;
  /** Points and lines. */
  readonly #leftOut = { primitives: 0, vertices: 0, places: new Set<string>() };
  /** By mesh. */
  readonly #shapes = new Map<number, readonly Shape[]>();
  readonly #read = new Tally();
  readonly #placed = new Tally();

  constructor(json: GltfJson, accessors: readonly Accessor[], materials: Materials, warnings: Warnings) {
    this.#json = json;
    this.#data = new VertexData(accessors);
    this.#materials = materials;
    this.#warnings = warnings;
  }

  /** @throws {LoadError} if that makes too many triangles. */
  place({ index, node, world }: PlacedNode): void {
    if (node.mesh === undefined) return;
    const shapes = this.#shapesOf(node.mesh);
    if (shapes.length === 0) return; // in however many places
    const instances = node.extensions?.EXT_mesh_gpu_instancing?.attributes;
    const path = `nodes[${index}]`;
    const places = instances === undefined ? [world] : this.#instanceMatrices(instances, world, path);
    for (const place of places) this.#add(shapes, place);
  }

  /** Says what of the meshes placed so far is not shown. */
  warnOfLeftOut(): void {
    const { primitives, vertices, places } = this.#leftOut;
    const parts = `${primitives} ${primitives === 1 ? "primitive" : "primitives"} of ${vertices} vertices`;
    for (const place of places) this.#warnings.add(`Points and lines are not shown: ${parts} left out`, place);
  }

  #shapesOf(mesh: number): readonly Shape[] {
    const known = this.#shapes.get(mesh);
    if (known !== undefined) return known;
    const shapes: Shape[] = [];
    this.#json.meshes[mesh]!.primitives.forEach((primitive, i) => {
      if (!hasTriangles(primitive)) {
        this.#leaveOut(primitive, mesh);
        return;
      }
      // Shared data is counted each time, because work and memory are spent on it each time.
      const { indices = primitive.attributes.POSITION } = primitive;
      this.#read.add(indices === undefined ? 0 : this.#data.at(indices).getCount() / 3, 0);
      const triangles = readTriangles(primitive, this.#data, `meshes[${mesh}].primitives[${i}]`, this.#warnings);
      if (triangles === undefined) return;
      this.#read.add(0, triangles.positions.length / 3);
      const { name, sets } = this.#materials.choose(primitive.material, triangles.uvs);
      const [uvs, uvs1] = sets.map((set) => triangles.uvs.get(set)!);
      shapes.push({ triangles, material: name, uvs: { ...(uvs && { uvs }), ...(uvs1 && { uvs1 }) } });
    });
    this.#shapes.set(mesh, shapes);
    return shapes;
  }

  #leaveOut({ attributes }: GltfPrimitive, mesh: number): void {
    const { POSITION } = attributes;
    this.#leftOut.primitives += 1;
    this.#leftOut.vertices += POSITION === undefined ? 0 : this.#data.at(POSITION).getCount();
    this.#leftOut.places.add(placeOf("meshes", mesh, this.#json.meshes[mesh]!.name));
  }

  #instanceMatrices(attributes: Readonly<Record<string, number>>, world: Float64Array, path: string): Float64Array[] {
    const data = this.#data;
    const counts = new Set(Object.values(attributes).map((index) => data.at(index).getCount()));
    if (counts.size > 1) throw new LoadError(`${path}: EXT_mesh_gpu_instancing has attributes of different lengths`);
    const read = (semantic: string, i: number, initial: number[]) =>
      attributes[semantic] === undefined ? initial : data.at(attributes[semantic]).getElement(i, [...initial]);
    const [count = 0] = counts;
    const matrices: Float64Array[] = [];
    for (let i = 0; i < count; i++) {
      const scale = read("SCALE", i, [1, 1, 1]);
      const local = compose(read("TRANSLATION", i, [0, 0, 0]), read("ROTATION", i, [0, 0, 0, 1]), scale);
      const matrix = mat4d.multiply(world, local);
      if (isWithinReach(matrix)) matrices.push(matrix);
    }
    const lost = count - matrices.length;
    if (lost > 0) this.#warnings.add("Instances at no finite place are left out", `${lost} of ${count} in ${path}`);
    return matrices;
  }

  #add(shapes: readonly Shape[], world: Float64Array): void {
    if (hasNoArea(world)) return; // no ray meets it
    for (const shape of shapes) {
      const { positions, normals, indices, colors, tangents } = shape.triangles;
      this.#placed.add(indices.length / 3, positions.length / 3);
      if (this.objects.length === MAX_OBJECTS)
        throw new LoadError(`has more than ${MAX_OBJECTS} meshes, in all places`);
      const isInPlace = isIdentity(world);
      const placed = isInPlace ? positions : transformPositions(positions, world);
      const reach = reachOf(placed);
      if (reach > MAX_DISTANCE) throw new LoadError(`has a vertex ${reach} m from the origin`);
      this.bounds.add(placed, indices);
      if (isMirror(world)) shape.flipped ??= flipWinding(indices);
      this.objects.push(
        mesh({
          positions: placed,
          indices: isMirror(world) ? shape.flipped! : indices,
          ...(normals && { normals: isInPlace ? normals : transformNormals(normals, world) }),
          ...shape.uvs,
          ...(colors && { colors }),
          ...(tangents && { tangents: isInPlace ? tangents : transformTangents(tangents, world) }),
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
