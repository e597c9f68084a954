import * as v from "valibot";

/** What a number may be; every bound that is given holds. */
export type Range = {
  readonly min?: number;
  readonly max?: number;
  /** Exclusive. */
  readonly above?: number;
  /** Exclusive. */
  readonly below?: number;
  readonly isInteger?: boolean;
};

/** What a schema of ours accepts, as data: valibot sees a function, from which no JSON Schema could be made. */
export type Shape =
  | ({ readonly kind: "number" } & Range)
  | { readonly kind: "object"; readonly entries: Readonly<Record<string, v.GenericSchema>> }
  | { readonly kind: "byType"; readonly options: Readonly<Record<string, v.GenericSchema>> }
  | { readonly kind: "list"; readonly item: v.GenericSchema }
  | {
      readonly kind: "tuple";
      readonly length: number;
      readonly item: v.GenericSchema;
      readonly isNonZero?: boolean;
    }
  | { readonly kind: "stringOr"; readonly object: v.GenericSchema }
  | { readonly kind: "dictionary"; readonly item: v.GenericSchema };

/** The part of a pipe that says what the pipe accepts; a later one overrides an earlier one. */
export function hasShape<In>(shape: Shape): v.MetadataAction<In, { readonly shape: Shape }> {
  return v.metadata({ shape });
}

/** What `hasShape` says in the pipe of this schema. */
export function shapeOf(schema: v.GenericSchema): Shape | undefined {
  return v.getMetadata(schema).shape as Shape | undefined;
}
