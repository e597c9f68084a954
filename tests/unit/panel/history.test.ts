import { expect, it } from "vitest";
import { RecentHistory } from "../../../src/panel/history";

it("a strip keeps the latest points", () => {
  const history = new RecentHistory(3);
  expect(history.values).toEqual([]);
  for (let value = 0; value < 10; value++) history.add(value);
  expect(history.values).toEqual([7, 8, 9]);
});
