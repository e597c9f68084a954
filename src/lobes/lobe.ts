// What a lobe is: a way in which a material scatters light; the contract between its file and the compiler.
//
// WGSL expressions call functions of the shader module beside a lobe's file by their full names, package::lobes::ggx::ggxValue.
// They are of `bsdf: Bsdf`, how the surface scatters; `wo: vec3f`, towards the viewer, in the local frame; and what is named below.

import type { ResolvedMaterial, TextureField, Vec3 } from "../scene/schema";

/** By their names, the conditions of the shader modules' `@if`s: whether some material needs what they guard. */
export type MaterialFeatures = Readonly<Record<string, boolean>>;

/** A column of the table of materials: a member of `Material` and of `Bsdf`. */
export type Column = {
  /** What the shader reads it for; it has no column without. */
  readonly when: (features: MaterialFeatures) => boolean;
  /** A texture that multiplies it: by its colour, which is sRGB, or by one of its numbers, and that leaves at least so much of it. */
  readonly texture?: readonly [field: TextureField, part: "color" | "r" | "g" | "b" | "a", least?: number];
} & (
  | { readonly type: "f32"; readonly of: (material: ResolvedMaterial) => number }
  | { readonly type: "vec3f"; readonly of: (material: ResolvedMaterial) => Vec3 }
);

/** What the shader has of materials: conditions and columns. */
export type MaterialPart = {
  readonly features: {
    readonly [name: string]: {
      readonly isIn: (material: ResolvedMaterial) => boolean;
      /** What people call it. */
      readonly word?: string;
    };
  };
  readonly columns: { readonly [name: string]: Column };
  /** Members of `Bsdf` that are made of others, of `wo`, one after the other; they may take the place of others. */
  readonly derived?: {
    readonly [name: string]: Pick<Column, "type" | "when"> & { readonly from: string };
  };
};

/** What lies on the lobes listed before its own. */
export type Layer = {
  /** The one of its lobes' features that says whether the scene has it. */
  readonly feature: string;
  /** How much light passes it on its way from `wi` to what is below and back to `wo`. */
  readonly through: string;
  /** Roughly how much light of what leaves towards `wo` passes it. */
  readonly out: string;
};

/** A way to scatter light. */
export type Lobe = MaterialPart & {
  /** The layer that it is the reflection of; lobes without one are those of the surface itself. */
  readonly layer?: Layer;
  /** The one of its features that says whether the scene has the lobe. */
  readonly feature: string;
  /** Whether its directions are those below the surface, or some of them. */
  readonly isBelow?: boolean | "some";
  /** The luminance that it is expected to scatter from `wo`: lobes are drawn in proportion to it. */
  readonly share: string;
} & (
    | {
        /** A `BsdfValue` of `at: Directions`. */
        readonly value: string;
        /** A direction, of the random point `u` of the unit square; zero if there is none. Of a lobe some of whose directions are below, of a
         * random `rest` too. */
        readonly sample: string;
        /** A `BsdfSample` of `u`, exact, for scenes without another lobe. */
        readonly alone?: string;
        /** Whether f is much the same in all directions: with no other lobe, lights are chosen without it. */
        readonly isEven?: boolean;
        /** Roughly the mean of f over a ball of light of radius `size` at distance 1 in direction `wi`,
         * whose cosine is `cosI` as far as it is on the lobe's side; to choose lights by. */
        readonly expect: string;
      }
    | {
        /** Of a lobe in one direction only: a `BsdfSample` of density 0, of the lobe's `share`. */
        readonly delta: string;
      }
  );
