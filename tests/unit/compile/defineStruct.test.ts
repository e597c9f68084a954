import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { defineStruct, type StructFields } from "../../../src/compile/defineStruct";
import { FRAME, LIGHT, PLACED_TEXTURE, TEXTURE, VIEW } from "../../../src/compile/layouts";
import { layOut, parseStruct, readStruct } from "../../support/wgslStruct";

/** Byte offset of every field, as `write` uses them: found by writing one field at a time. */
function offsetsOf<F extends StructFields>(fields: F): Record<string, number> {
  const layout = defineStruct(fields);
  const offsets: Record<string, number> = {};
  for (const name of Object.keys(fields)) {
    const view = new DataView(new ArrayBuffer(layout.bytes));
    const isScalar = (type: string | undefined) => type === "f32" || type === "u32";
    const value = Object.entries(fields).map(([other, type]) => {
      const first = other === name ? 1 : 0;
      return [other, isScalar(type) ? first : [first, 0, 0, 0]] as const;
    });
    layout.write(view, 0, Object.fromEntries(value) as never);
    offsets[name] = new Uint8Array(view.buffer).findIndex((byte) => byte !== 0) & ~3;
  }
  return offsets;
}

test("scalars are packed, vectors aligned", () => {
  expect(offsetsOf({ a: "f32", b: "vec3f", c: "f32", d: "u32", e: "vec2u", f: "vec4f" })).toEqual({
    a: 0,
    b: 16,
    c: 28, // the gap behind a vec3f
    d: 32,
    e: 40,
    f: 48,
  });
});

test.each<[number, StructFields]>([
  [16, { a: "f32" }],
  [16, { a: "vec3f", b: "f32" }],
  [32, { a: "f32", b: "vec3f" }],
  [32, { a: "vec4f", b: "u32" }],
  [48, { a: "vec3f", b: "vec3f", c: "vec3f" }],
])("a struct takes %i bytes: a multiple of 16, as arrays in uniforms want", (bytes, fields) => {
  expect(defineStruct(fields).bytes).toBe(bytes);
});

test("values land in their fields, little-endian, and nowhere else", () => {
  const layout = defineStruct({ ids: "vec2u", scale: "f32", color: "vec3f", count: "u32" });
  const view = new DataView(new ArrayBuffer(layout.bytes + 32));
  const value = { ids: [1, 0xffffffff], scale: -0.5, color: [1, 2, 3], count: 7 };
  layout.write(view, 16, value);
  expect(readStruct(view, 16, Object.entries(layout.fields))).toEqual(value);
  const outside = [...new Uint8Array(view.buffer, 0, 16), ...new Uint8Array(view.buffer, 16 + layout.bytes)];
  expect(outside.every((byte) => byte === 0)).toBe(true);
});

test("typed arrays are as good as arrays", () => {
  const layout = defineStruct({ direction: "vec3f" });
  const view = new DataView(new ArrayBuffer(layout.bytes));
  layout.write(view, 0, { direction: new Float64Array([0.25, 0.5, 1]) });
  expect(readStruct(view, 0, [["direction", "vec3f"]])).toEqual({ direction: [0.25, 0.5, 1] });
});

const MIRRORED = [
  ["Texture", "wgsl/textures", PLACED_TEXTURE],
  ["Light", "lights/light", LIGHT],
  ["FrameUniforms", "wgsl/frameUniforms", FRAME],
  ["View", "wgsl/blit", VIEW],
] as const;

test("Texture without UV_TRANSFORMS is the same struct without what is under it", () => {
  const wgsl = readFileSync(new URL("../../../src/wgsl/textures.wgsl", import.meta.url), "utf8");
  const declared = parseStruct(wgsl.replaceAll(/@if\(UV_TRANSFORMS\).*/g, ""), "Texture");
  expect(Object.entries(TEXTURE.fields)).toEqual(declared);
  expect(declared.length).toBeLessThan(Object.keys(PLACED_TEXTURE.fields).length);
});

test.each(MIRRORED)("%s in %s.wgsl and its table in TypeScript are the same struct", (name, module, layout) => {
  const wgsl = readFileSync(new URL(`../../../src/${module}.wgsl`, import.meta.url), "utf8");
  const declared = parseStruct(wgsl, name);
  expect(Object.entries(layout.fields)).toEqual(declared);

  const { offsets, bytes } = layOut(declared);
  expect(offsetsOf(layout.fields)).toEqual(Object.fromEntries(offsets));
  // Rounded up to 16 here: the stride of an array, and never less than the struct.
  expect(layout.bytes).toBe(Math.ceil(bytes / 16) * 16);
});
