import { describe, expect, test } from "vitest";
import { Literals, type Row, type RowType, Slots } from "../../../src/compile/values";

test("a scalar fills the fourth component of a vector's slot", () => {
  const slots = new Slots();
  expect(slots.vec3([1, 2, 3])).toBe("scene.slots[0].xyz");
  expect(slots.scalar(4)).toBe("scene.slots[0].w");
  expect(slots.numbers).toEqual([1, 2, 3, 4]);
});

test("a scalar without a vector before it opens a slot of its own", () => {
  const slots = new Slots();
  expect(slots.scalar(7)).toBe("scene.slots[0].x");
  expect(slots.numbers).toEqual([7, 0, 0, 0]);
});

test("free components are filled in order, each once", () => {
  const slots = new Slots();
  slots.vec3([1, 2, 3]);
  slots.vec3([4, 5, 6]);
  const names = [8, 9, 10].map((value) => slots.scalar(value));
  expect(names).toEqual(["scene.slots[0].w", "scene.slots[1].w", "scene.slots[2].x"]);
  expect(slots.numbers).toEqual([1, 2, 3, 8, 4, 5, 6, 9, 10, 0, 0, 0]);
});

test("every name reads back its own value, whatever the order", () => {
  const slots = new Slots();
  const named = new Map<string, number[]>();
  for (let i = 1; i <= 50; i++) {
    if (i % 3 === 0) named.set(slots.scalar(i), [i]);
    else named.set(slots.vec3([i, i + 0.25, i + 0.5]), [i, i + 0.25, i + 0.5]);
  }
  expect(named.size).toBe(50);
  for (const [name, value] of named) {
    const [, slot, components] = /^scene\.slots\[(\d+)\]\.([xyzw]+)$/.exec(name)!;
    const read = [...components!].map((component) => slots.numbers[4 * Number(slot) + "xyzw".indexOf(component)]);
    expect(read, name).toEqual(value);
  }
});

describe("literals", () => {
  const literals = new Literals();
  const lookup = (type: RowType, rows: readonly Row[]) =>
    literals.lookup("scene.x[i]", type, rows.length, (i) => rows[i]!);

  test("are the nearest f32, always with a point or an exponent", () => {
    expect(literals.scalar(0.1)).toBe("0.10000000149011612");
    expect(literals.scalar(2)).toBe("2.0");
    expect(literals.scalar(-1e-20)).toBe("-9.999999682655225e-21");
    expect(literals.vec3([1, -2, 0.5])).toBe("vec3f(1.0, -2.0, 0.5)");
  });

  test("a table is a chain of selects that starts from the commonest row", () => {
    expect(lookup("f32", [[1], [2], [2], [3], [1], [2]])).toBe(
      "  var value = f32(2.0);\n" +
        "  value = select(value, f32(1.0), (i == 0u) | (i == 4u));\n" +
        "  value = select(value, f32(3.0), (i == 3u));\n" +
        "  return value;\n",
    );
    expect(lookup("u32", [[4294967295]])).toContain("u32(4294967295)");
  });

  test("a table of many different rows, or of none, stays in the uniform", () => {
    const rows = Array.from({ length: 40 }, (_, i) => [i]);
    expect(lookup("f32", rows)).toBe("  return scene.x[i];\n");
    expect(lookup("f32", [])).toBe("  return scene.x[i];\n");
  });

  test("so does one in which too many are unlike the commonest, whatever the order", () => {
    const alternating = (count: number) => Array.from({ length: count }, (_, i) => [i % 2]);
    expect(lookup("f32", alternating(96))).toContain("select");
    expect(lookup("f32", alternating(98))).toBe("  return scene.x[i];\n");
    const few = [...Array.from({ length: 5000 }, () => [7]), [1], [2], [1]];
    expect(lookup("f32", few)).toBe(
      "  var value = f32(7.0);\n" +
        "  value = select(value, f32(1.0), (i == 5000u) | (i == 5002u));\n" +
        "  value = select(value, f32(2.0), (i == 5001u));\n" +
        "  return value;\n",
    );
  });
});
