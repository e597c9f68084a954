import { expect, it } from "vitest";
import { decades } from "../../../src/panel/graph";

it("powers of ten are marked on a logarithmic axis, both ends included", () => {
  expect(decades(-1, 1, String)).toEqual([
    { at: -1, text: "0.1" },
    { at: 0, text: "1" },
    { at: 1, text: "10" },
  ]);
  expect(decades(-0.9, 0.9, String)).toEqual([{ at: 0, text: "1" }]);
  expect(decades(0.1, 0.9, String)).toEqual([]);
});
