/** WGSL types a host-shared struct of ours may hold, with alignment, size in bytes and component count. */
const TYPES = {
  f32: { align: 4, size: 4, count: 1 },
  u32: { align: 4, size: 4, count: 1 },
  vec2u: { align: 8, size: 8, count: 2 },
  vec2f: { align: 8, size: 8, count: 2 },
  vec3u: { align: 16, size: 12, count: 3 },
  vec3f: { align: 16, size: 12, count: 3 },
  vec4f: { align: 16, size: 16, count: 4 },
} as const;

type TypeName = keyof typeof TYPES;
type ValueOf<T extends TypeName> = T extends "f32" | "u32" ? number : ArrayLike<number>;

/** Field names and WGSL types, in declaration order. */
export type StructFields = Readonly<Record<string, TypeName>>;
export type StructValue<F extends StructFields> = { readonly [K in keyof F]: ValueOf<F[K]> };

export type StructLayout<F extends StructFields> = {
  readonly fields: F;
  /** Size in bytes, a multiple of 16: the stride of an array in a uniform buffer. */
  readonly bytes: number;
  /** Writes one value at `byteOffset`. */
  write(target: DataView, byteOffset: number, value: StructValue<F>): void;
};

/**
 * Lays out a struct as WGSL does in the uniform address space. The WGSL declaration must list the same fields in the
 * same order; `tests/unit/compile/defineStruct.test.ts` holds every pair together.
 */
export function defineStruct<const F extends StructFields>(fields: F): StructLayout<F> {
  let end = 0;
  const places = Object.entries(fields).map(([name, type]) => {
    const { align, size, count } = TYPES[type];
    const offset = roundUp(end, align);
    end = offset + size;
    return { name, offset, count, isFloat: type.endsWith("f") || type === "f32" };
  });

  return {
    fields,
    bytes: roundUp(end, 16),
    write(target, byteOffset, value) {
      for (const { name, offset, count, isFloat } of places) {
        const field: number | ArrayLike<number> = value[name as keyof F];
        for (let i = 0; i < count; i++) {
          const at = byteOffset + offset + 4 * i;
          const component = typeof field === "number" ? field : (field[i] ?? 0);
          if (isFloat) target.setFloat32(at, component, true);
          else target.setUint32(at, component, true);
        }
      }
    },
  };
}

/** The struct's declaration in WGSL. */
export function emitStruct<F extends StructFields>(name: string, { fields }: StructLayout<F>): string {
  const members = Object.entries(fields).map(([field, type]) => `  ${field}: ${type},\n`);
  return `struct ${name} {\n${members.join("")}}\n`;
}

function roundUp(value: number, multiple: number): number {
  return Math.ceil(value / multiple) * multiple;
}
