// The materials that meshes turn out to need, each with the textures that its mesh has texture coordinates for.

import { show } from "../../scene/describe";
import type { Material, TextureField, TextureReference } from "../../scene/schema";
import { wholeReference } from "../../scene/textureReference";
import type { Warnings } from "../warnings";
import type { GltfMaterial, GltfTextureInfo } from "./materialSchema";
import type { GltfJson } from "./schema";
import { type Surface, surfaceOf } from "./surface";
import { coordinateSet, placedTexture } from "./textureCoordinates";
import type { Reading, Textures } from "./textures";

/** The textures that are read as sRGB; the others are data. */
const COLORS: ReadonlySet<TextureField> = new Set([
  "baseColorTexture",
  "emissionTexture",
  "specularColorTexture",
  "sheenColorTexture",
  "diffuseTransmissionColorTexture",
]);

/** A material for one mesh. */
export type ChosenMaterial = {
  readonly name: string;
  /** Numbers, in the file, of the texture coordinates that it looks its textures up with: `uvs` of a mesh, and `uvs1`. */
  readonly sets: readonly number[];
};

/** Sets of texture coordinates that a mesh of ours may have. */
const MAX_SETS = 2;
const NO_SET = "A texture is left out on meshes that lack its texture coordinates";
const NO_MORE_SETS =
  "A texture is left out because others of its material have two sets of texture coordinates already";

type Shown = { readonly field: TextureField; readonly name: string; readonly texture: GltfTextureInfo };

/** glTF 2.0, 3.9.6: what has no material is like this. */
const DEFAULT: GltfMaterial = {};

/** Makes the materials that meshes turn out to need. */
export class Materials {
  readonly #json: GltfJson;
  readonly #textures: Textures;
  readonly #warnings: Warnings;
  readonly #surfaces = new Map<number | undefined, Surface>();
  readonly #made: Record<string, Material> = Object.create(null);
  readonly #chosen = new Map<string, ChosenMaterial>();
  /** The next number to try behind a name that is taken. Every number is tried once, whatever the names. */
  readonly #nextNumber = new Map<string, number>();

  constructor(json: GltfJson, textures: Textures, warnings: Warnings) {
    this.#json = json;
    this.#textures = textures;
    this.#warnings = warnings;
  }

  /** The materials chosen so far, by name. */
  get all(): Readonly<Record<string, Material>> {
    return this.#made;
  }

  /**
   * The material of a mesh. A mesh without texture coordinates gets one without textures.
   *
   * @param index - in the file; `undefined` for the default.
   * @param sets - the mesh's sets of texture coordinates.
   */
  choose(index: number | undefined, sets: { has(set: number): boolean }): ChosenMaterial {
    const surface = this.#surfaceOf(index);
    const shown: Shown[] = [];
    const used = new Set<number>();
    for (const [field, texture] of surface.textures) {
      if (texture === undefined) continue;
      const set = coordinateSet(texture);
      const obstacle = !sets.has(set) ? NO_SET : used.size === MAX_SETS && !used.has(set) ? NO_MORE_SETS : undefined;
      if (obstacle !== undefined) {
        this.#warnings.add(obstacle, `${this.#placeOf(index)}, ${field}`);
        continue;
      }
      const name = this.#textures.use(texture.index, readingOf(field, surface));
      if (name === undefined) continue;
      shown.push({ field, name, texture });
      used.add(set);
    }
    const { tangentSet } = surface;
    if (tangentSet !== undefined && sets.has(tangentSet) && used.size < MAX_SETS) used.add(tangentSet);
    return this.#make(
      index,
      surface,
      shown,
      [...used].sort((a, b) => a - b),
    );
  }

  #make(
    index: number | undefined,
    { fields, glossiness }: Surface,
    shown: readonly Shown[],
    sets: readonly number[],
  ): ChosenMaterial {
    const references = shown.map(({ field, name, texture }) => {
      return [field, placedTexture(name, sets.indexOf(coordinateSet(texture)) as 0 | 1, texture)] as const;
    });
    const textures: Partial<Record<TextureField, TextureReference>> = Object.fromEntries(references);
    const key = JSON.stringify([index, textures, sets]);
    const known = this.#chosen.get(key);
    if (known !== undefined) return known;
    const isRoughAsPicture = glossiness !== undefined && textures.metallicRoughnessTexture !== undefined;
    const name = this.#freeName(this.#material(index).name || (index === undefined ? "default" : `material ${index}`));
    this.#made[name] = { ...fields, ...(isRoughAsPicture && { roughness: 1 }), ...textures };
    const chosen = { name, sets };
    this.#chosen.set(key, chosen);
    return chosen;
  }

  #surfaceOf(index: number | undefined): Surface {
    const known = this.#surfaces.get(index);
    if (known !== undefined) return known;
    const surface = surfaceOf(this.#material(index), (text) => this.#warnings.add(text, this.#placeOf(index)));
    this.#surfaces.set(index, surface);
    return surface;
  }

  #material(index: number | undefined): GltfMaterial {
    return this.#json.materials[index ?? -1] ?? DEFAULT;
  }

  #placeOf(index: number | undefined): string {
    return index === undefined ? "the default material" : placeOf("materials", index, this.#material(index).name);
  }

  #freeName(wanted: string): string {
    let name = wanted;
    let number = this.#nextNumber.get(wanted) ?? 2;
    while (name in this.#made) name = `${wanted} ${number++}`;
    this.#nextNumber.set(wanted, number);
    return name;
  }
}

function readingOf(field: TextureField, { glossiness }: Surface): Reading {
  if (field === "metallicRoughnessTexture" && glossiness !== undefined) return { glossiness };
  return COLORS.has(field) ? "color" : "data";
}

/** Materials without the textures that turned out to have no picture: those multiply by 1. */
export function withoutMissing(
  materials: Readonly<Record<string, Material>>,
  textures: Readonly<Record<string, unknown>>,
): Readonly<Record<string, Material>> {
  const shown: Record<string, Material> = Object.create(null);
  for (const [name, material] of Object.entries(materials)) {
    const isMissing = ([field, value]: readonly [string, unknown]) =>
      /Texture$/.test(field) && !Object.hasOwn(textures, wholeReference(value as TextureReference).texture);
    shown[name] = Object.fromEntries(Object.entries(material).filter((entry) => !isMissing(entry))) as Material;
  }
  return shown;
}

/** `materials[3] "Glass"`. */
export function placeOf(list: string, index: number, name: string | undefined): string {
  return `${list}[${index}]${name ? ` ${show(name)}` : ""}`;
}
