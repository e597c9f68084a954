import { expect, test } from "vitest";
import { readSchemaDocs } from "../../../tools/schemaDocs";

const SOURCE = `
/** A number of things. */
const count = number();

/**
 * A thing, described
 * in two lines.
 *
 * And a paragraph.
 *
 * @throws never
 */
export const Thing = v.pipe(
  strictObject({
    /** Its size. */
    size: count,
    count,
    parts: v.optional(list(Thing), []),
    // no docstring
    plain: v.string(),
  }),
  v.transform((x) => x),
);
`;

test("a constant has its docstring, without stars and tags", () => {
  expect(readSchemaDocs(SOURCE).get("Thing")?.text).toBe("A thing, described in two lines.\n\nAnd a paragraph.");
});

test("a field has its own docstring, or that of the constant it refers to", () => {
  const fields = readSchemaDocs(SOURCE).get("Thing")?.fields;
  expect(fields?.get("size")?.text).toBe("Its size.");
  expect(fields?.get("count")?.text).toBe("A number of things.");
  expect(fields?.get("plain")?.text).toBeUndefined();
});

test("the docstring of an item does not describe the list", () => {
  const things = readSchemaDocs(
    "/** Things. */ const x = strictObject({ all: list(Thing) });",
    readSchemaDocs(SOURCE),
  ).get("x");
  expect(things?.fields.get("all")?.text).toBeUndefined();
  expect(things?.fields.get("all")?.item?.fields.get("size")?.text).toBe("Its size.");
});

test("a source that does not parse is an error", () => {
  expect(() => readSchemaDocs("const = 1")).toThrow(SyntaxError);
});
