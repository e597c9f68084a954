// What a lobe is: a way in which a material scatters light; the contract between its file and the compiler.
//
// WGSL expressions call functions of the shader module beside a lobe's file by their full names, package::lobes::ggx::ggxValue.
// They are of `bsdf: Bsdf`, how the surface scatters; `wo: vec3f`, towards the viewer, in the local frame; and what is named below.

import type { ResolvedMaterial, Vec3 } from "../scene/schema";

/** By their names, the conditions of the shader modules' `@if`s: whether some material needs what they guard. */
export type MaterialFeatures = Readonly<Record<string, boolean>>;

/** A column of the table of materials: a member of `Material` and of `Bsdf`. */
export type Column = {
  /** What the shader reads it for; it has no column without. */
  readonly when: (features: MaterialFeatures) => boolean;
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
};

/** A way to scatter light. */
export type Lobe = MaterialPart & {
  /** The one of its features that says whether the scene has the lobe. */
  readonly feature: string;
  /** The luminance that it is expected to scatter from `wo`: lobes are drawn in proportion to it. */
  readonly share: string;
  /** Members of `Bsdf` that depend on `wo`. */
  readonly derived?: {
    readonly [name: string]: Pick<Column, "type" | "when"> & { readonly from: string };
  };
} & (
    | {
        /** A `BsdfValue` of `at: Directions`. */
        readonly value: string;
        /** A direction, of the random point `u` of the unit square. */
        readonly sample: string;
        /** A `BsdfSample` of `u`, exact, for scenes without another lobe. */
        readonly alone?: string;
        /** Whether f is much the same in all directions: with no other lobe, lights are chosen without it. */
        readonly isEven?: boolean;
        /** Roughly the mean of f over a ball of light of radius `size` at distance 1 in direction `wi`,
         * whose cosine is `cosI` as far as it is above the surface; to choose lights by. */
        readonly expect: string;
      }
    | {
        /** Of a lobe in one direction only: a `BsdfSample` of density 0, of the lobe's `share`. */
        readonly delta: string;
      }
  );
