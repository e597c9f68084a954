// Surfaces: glTF's metallic-roughness model is ours, so most of this is names and defaults.

import { show } from "../../scene/describe";
import type { Material, Rgb, TextureReference } from "../../scene/schema";
import { wholeReference } from "../../scene/textureReference";
import type { Warnings } from "../warnings";
import type { GltfJson } from "./schema";
import { coordinateSet, placedTexture } from "./textureCoordinates";
import type { Textures } from "./textures";

type GltfMaterial = GltfJson["materials"][number];
type TextureField = "baseColorTexture" | "normalTexture" | "metallicRoughnessTexture" | "emissionTexture";
type Slot = readonly [field: TextureField, texture: NonNullable<GltfMaterial["emissiveTexture"]> | undefined];

/** The textures that are read as sRGB; the others are data. */
const COLORS: ReadonlySet<TextureField> = new Set(["baseColorTexture", "emissionTexture"]);

/** A material for one mesh. */
export type ChosenMaterial = {
  readonly name: string;
  /** Numbers, in the file, of the texture coordinates that it looks its textures up with: `uvs` of a mesh, and `uvs1`. */
  readonly sets: readonly number[];
};

/** Sets of texture coordinates that a mesh of ours may have. */
const MAX_SETS = 2;

/** glTF 2.0, 3.9.6: what has no material is like this. */
const DEFAULT: GltfMaterial = {};

/** Makes the materials that meshes turn out to need. */
export class Materials {
  readonly #json: GltfJson;
  readonly #textures: Textures;
  readonly #warnings: Warnings;
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
    const material = this.#json.materials[index ?? -1] ?? DEFAULT;
    const place = index === undefined ? "the default material" : placeOf("materials", index, material.name);
    const shown: { field: TextureField; name: string; texture: NonNullable<Slot[1]> }[] = [];
    const used = new Set<number>();
    for (const [field, texture] of slotsOf(material)) {
      if (texture === undefined) continue;
      const set = coordinateSet(texture);
      if (!sets.has(set)) {
        this.#warnings.add("A texture is left out on meshes that lack its texture coordinates", `${place}, ${field}`);
      } else if (used.size === MAX_SETS && !used.has(set)) {
        this.#warnings.add(
          "A texture is left out because others of its material have two sets of texture coordinates already",
          `${place}, ${field}`,
        );
      } else {
        const name = this.#textures.use(texture.index, COLORS.has(field));
        if (name === undefined) continue;
        shown.push({ field, name, texture });
        used.add(set);
      }
    }
    const inOrder = [...used].sort((a, b) => a - b);
    const references = shown.map(({ field, name, texture }) => {
      const uv = inOrder.indexOf(coordinateSet(texture)) as 0 | 1;
      return [field, placedTexture(name, uv, texture)] as const;
    });
    return this.#make(index, material, place, Object.fromEntries(references), inOrder);
  }

  #make(
    index: number | undefined,
    material: GltfMaterial,
    place: string,
    textures: Partial<Record<TextureField, TextureReference>>,
    sets: readonly number[],
  ): ChosenMaterial {
    const key = JSON.stringify([index, textures, sets]);
    const known = this.#chosen.get(key);
    if (known !== undefined) return known;
    const wanted = material.name || (index === undefined ? "default" : `material ${index}`);
    const name = this.#freeName(wanted);
    this.#made[name] = { ...this.#factors(material, place), ...textures };
    const chosen = { name, sets };
    this.#chosen.set(key, chosen);
    return chosen;
  }

  #freeName(wanted: string): string {
    let name = wanted;
    let number = this.#nextNumber.get(wanted) ?? 2;
    while (name in this.#made) name = `${wanted} ${number++}`;
    this.#nextNumber.set(wanted, number);
    return name;
  }

  #factors(material: GltfMaterial, place: string): Material {
    const {
      baseColorFactor = [1, 1, 1, 1],
      metallicFactor = 1,
      roughnessFactor = 1,
    } = material.pbrMetallicRoughness ?? {};
    const { normalTexture, doubleSided } = material;
    const emission = emissionOf(material);
    const ior = material.extensions?.KHR_materials_ior?.ior ?? 1.5;
    if (ior < 1) this.#warnings.add(`KHR_materials_ior: ${ior} is not supported: 1.5 takes its place`, place);
    return {
      baseColor: baseColorFactor.slice(0, 3).map(toFraction) as unknown as Rgb,
      metallic: toFraction(metallicFactor),
      roughness: toFraction(roughnessFactor),
      ...(ior >= 1 && { ior }),
      ...(isEmissive(emission) && { emission }),
      ...(normalTexture?.scale !== undefined && { normalScale: normalTexture.scale }),
      ...alphaOf(material),
      ...(doubleSided && isEmissive(emission) && { doubleSided }),
      ...(material.extensions?.KHR_materials_unlit && { unlit: true }),
    };
  }
}

/** What of a surface is there. */
function alphaOf({ alphaMode = "OPAQUE", alphaCutoff, pbrMetallicRoughness }: GltfMaterial): Partial<Material> {
  if (alphaMode === "OPAQUE") return {};
  const alpha = toFraction(pbrMetallicRoughness?.baseColorFactor?.[3] ?? 1);
  if (alphaMode === "BLEND") return { alphaMode: "blend", alpha };
  return { alphaMode: "mask", alpha, ...(alphaCutoff !== undefined && { alphaCutoff }) };
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

/** In the order in which they get texture coordinates, while there are any. */
function slotsOf(material: GltfMaterial): Slot[] {
  const { baseColorTexture, metallicRoughnessTexture } = material.pbrMetallicRoughness ?? {};
  const { normalTexture, emissiveTexture } = material;
  return [
    ["baseColorTexture", baseColorTexture],
    ["normalTexture", normalTexture],
    ["metallicRoughnessTexture", metallicRoughnessTexture],
    ["emissionTexture", isEmissive(emissionOf(material)) ? emissiveTexture : undefined],
  ];
}

/** Radiance: emission of strength 1 is 1 W·sr⁻¹·m⁻². */
function emissionOf({ emissiveFactor = [0, 0, 0], extensions }: GltfMaterial): Rgb {
  const strength = extensions?.KHR_materials_emissive_strength?.emissiveStrength ?? 1;
  return emissiveFactor.map((channel) => channel * strength) as unknown as Rgb;
}

function isEmissive(emission: Rgb): boolean {
  return emission.some((channel) => channel > 0);
}

function toFraction(value: number): number {
  return Math.min(1, Math.max(0, value));
}

/** `materials[3] "Glass"`. */
export function placeOf(list: string, index: number, name: string | undefined): string {
  return `${list}[${index}]${name ? ` ${show(name)}` : ""}`;
}
