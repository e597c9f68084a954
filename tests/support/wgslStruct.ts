// Structs as WGSL declares and lays them out: the tests' own account of what `defineStruct` promises.
//
// [1] WGSL, section "Alignment and Size", https://www.w3.org/TR/WGSL/#alignment-and-size

/** A field of a struct: its name and its WGSL type. */
export type Field = readonly [name: string, type: string];

// [1], for the types our structs use.
const ALIGN_AND_SIZE: Readonly<Record<string, readonly [align: number, size: number]>> = {
  f32: [4, 4],
  u32: [4, 4],
  vec2u: [8, 8],
  vec2f: [8, 8],
  vec3u: [16, 12],
  vec3f: [16, 12],
  vec4f: [16, 16],
};

/** The fields of the struct `name` in a WGSL text, in declaration order. */
export function parseStruct(wgsl: string, name: string): Field[] {
  const code = wgsl.replaceAll(/\/\/.*/g, "");
  const body = new RegExp(`struct\\s+${name}\\s*\\{([^}]*)\\}`).exec(code)?.[1];
  if (body === undefined) throw new Error(`no struct ${name}`);
  return [...body.matchAll(/(\w+)\s*:\s*(\w+(?:<[^>]*>)?)/g)].map(([, field, type]) => [field!, type!]);
}

/** Byte offset of every field, and the struct's size. [1] */
export function layOut(fields: readonly Field[]): { offsets: Map<string, number>; bytes: number } {
  let end = 0;
  let align = 1;
  const offsets = new Map<string, number>();
  for (const [name, type] of fields) {
    const [fieldAlign, size] = ALIGN_AND_SIZE[type]!;
    end = Math.ceil(end / fieldAlign) * fieldAlign;
    offsets.set(name, end);
    end += size;
    align = Math.max(align, fieldAlign);
  }
  return { offsets, bytes: Math.ceil(end / align) * align };
}

/** The values of a struct that starts at `byteOffset`: numbers for scalars, arrays for vectors. */
export function readStruct(view: DataView, byteOffset: number, fields: readonly Field[]) {
  const { offsets } = layOut(fields);
  const values: Record<string, number | number[]> = {};
  for (const [name, type] of fields) {
    const components = Array.from({ length: ALIGN_AND_SIZE[type]![1] / 4 }, (_, i) => {
      const at = byteOffset + offsets.get(name)! + 4 * i;
      return type.startsWith("u") || type.endsWith("u") ? view.getUint32(at, true) : view.getFloat32(at, true);
    });
    values[name] = components.length === 1 ? components[0]! : components;
  }
  return values;
}
