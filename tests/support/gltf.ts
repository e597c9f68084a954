// glTF files made by hand: valid ones to start from, which a test then bends.

import type { Scene, SceneObject } from "../../src/scene/schema";
import type { MeshData } from "./meshes";

type Json = Record<string, unknown>;

/** A .glb of this JSON and this binary chunk; its one buffer is added. */
export function glb(json: Json, binary: Uint8Array = new Uint8Array()): Uint8Array {
  const buffers = binary.length > 0 ? [{ byteLength: binary.length }] : undefined;
  return container(JSON.stringify({ asset: { version: "2.0" }, ...(buffers && { buffers }), ...json }), binary);
}

/** A .glb of this text and this binary chunk, padded as the format wants it. */
export function container(text: string, binary: Uint8Array): Uint8Array {
  const json = new TextEncoder().encode(text.padEnd(Math.ceil(text.length / 4) * 4));
  const paddedLength = Math.ceil(binary.length / 4) * 4;
  const bytes = new Uint8Array(12 + 8 + json.length + (binary.length > 0 ? 8 + paddedLength : 0));
  const view = new DataView(bytes.buffer);
  [0x46546c67, 2, bytes.length, json.length, 0x4e4f534a].forEach((word, i) => void view.setUint32(4 * i, word, true));
  bytes.set(json, 20);
  if (binary.length > 0) {
    view.setUint32(20 + json.length, paddedLength, true);
    view.setUint32(24 + json.length, 0x004e4942, true);
    bytes.set(binary, 28 + json.length);
  }
  return bytes;
}

type Values = Float32Array | Uint32Array | Uint16Array | Uint8Array | Int16Array | Int8Array;

const COMPONENT_TYPES = new Map<unknown, number>([
  [Int8Array, 5120],
  [Uint8Array, 5121],
  [Int16Array, 5122],
  [Uint16Array, 5123],
  [Uint32Array, 5125],
  [Float32Array, 5126],
]);

/** Collects arrays in one buffer, a view and an accessor for each. */
export class Packer {
  readonly accessors: Json[] = [];
  readonly bufferViews: Json[] = [];
  #bytes: number[] = [];

  /** @returns the index of the accessor. */
  add(values: Values, type: "SCALAR" | "VEC2" | "VEC3" | "VEC4", more: Json = {}): number {
    const count = values.length / { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 }[type];
    const bufferView = this.addView(new Uint8Array(values.buffer, values.byteOffset, values.byteLength));
    const componentType = COMPONENT_TYPES.get(values.constructor);
    return this.accessors.push({ bufferView, componentType, type, count, ...more }) - 1;
  }

  /** @returns the index of the view. */
  addView(bytes: Uint8Array, more: Json = {}): number {
    while (this.#bytes.length % 4 !== 0) this.#bytes.push(0);
    const byteOffset = this.#bytes.length;
    for (const byte of bytes) this.#bytes.push(byte);
    return this.bufferViews.push({ buffer: 0, byteOffset, byteLength: bytes.length, ...more }) - 1;
  }

  /** A .glb with what was collected and this JSON. */
  file(json: Json): Uint8Array {
    return glb({ ...this.json, ...json }, this.binary);
  }

  get json(): Json {
    return { accessors: this.accessors, bufferViews: this.bufferViews };
  }

  get binary(): Uint8Array {
    return Uint8Array.from(this.#bytes);
  }
}

/** A right triangle in the plane z = 0, its front to +z. */
export const TRIANGLE = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0);

/** A file with that triangle. `change` may alter its JSON, and add to its buffer. */
export function triangleFile(change: (json: TriangleJson, packer: Packer) => void = () => {}): Uint8Array {
  const packer = new Packer();
  const json: TriangleJson = {
    meshes: [{ primitives: [{ attributes: { POSITION: packer.add(TRIANGLE, "VEC3") } }] }],
    nodes: [{ mesh: 0 }],
    scenes: [{ nodes: [0] }],
    scene: 0,
  };
  change(json, packer);
  return packer.file(json);
}

/** That file in green, and in the variants "Red" and "Blue". */
export function variantFile(change: (json: TriangleJson, packer: Packer) => void = () => {}): Uint8Array {
  return triangleFile((json, packer) => {
    const colors = { green: [0, 1, 0, 1], red: [1, 0, 0, 1], blue: [0, 0, 1, 1] };
    json.extensionsUsed = ["KHR_materials_variants"];
    json.extensions = { KHR_materials_variants: { variants: [{ name: "Red" }, { name: "Blue" }] } };
    json.materials = Object.entries(colors).map(([name, baseColorFactor]) => {
      return { name, pbrMetallicRoughness: { baseColorFactor, metallicFactor: 0 } };
    });
    const mappings = [
      { material: 1, variants: [0] },
      { material: 2, variants: [1] },
    ];
    Object.assign(json.meshes[0].primitives[0], {
      material: 0,
      extensions: { KHR_materials_variants: { mappings } },
    });
    change(json, packer);
  });
}

/** A file with one mesh, of any size: its arrays are not collected value by value. */
export function meshFile({ positions, indices }: Pick<MeshData, "positions" | "indices">): Uint8Array {
  const vertices = Float32Array.from(positions);
  const corners = Uint32Array.from(indices);
  const binary = new Uint8Array(vertices.byteLength + corners.byteLength);
  binary.set(new Uint8Array(vertices.buffer));
  binary.set(new Uint8Array(corners.buffer), vertices.byteLength);
  const json = {
    bufferViews: [
      { buffer: 0, byteLength: vertices.byteLength },
      { buffer: 0, byteOffset: vertices.byteLength, byteLength: corners.byteLength },
    ],
    accessors: [
      { bufferView: 0, componentType: 5126, type: "VEC3", count: vertices.length / 3, ...rangeOf(vertices) },
      { bufferView: 1, componentType: 5125, type: "SCALAR", count: corners.length },
    ],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    nodes: [{ mesh: 0 }],
    scenes: [{ nodes: [0] }],
    scene: 0,
  };
  return glb(json, binary);
}

/** Least and most of each coordinate: an accessor of positions has to say so. */
function rangeOf(vertices: Float32Array): { min: number[]; max: number[] } {
  const [min, max] = [Array(3).fill(Number.POSITIVE_INFINITY), Array(3).fill(Number.NEGATIVE_INFINITY)];
  for (const [i, value] of vertices.entries()) {
    min[i % 3] = Math.min(min[i % 3], value);
    max[i % 3] = Math.max(max[i % 3], value);
  }
  return { min, max };
}

// biome-ignore lint/suspicious/noExplicitAny: tests put anything in, right or wrong.
export type TriangleJson = Record<string, any>;

export type MeshObject = Extract<SceneObject, { type: "mesh" }>;

export function meshesOf({ objects }: Scene): readonly MeshObject[] {
  return objects.filter((object) => object.type === "mesh");
}

/** Where a mesh's vertices are, rounded so that -0 and rounding don't matter. */
export function roundedNumbers(values: ArrayLike<number> | undefined): number[] {
  return Array.from(values ?? [], (value) => Math.round(value * 1e5) / 1e5 + 0);
}
