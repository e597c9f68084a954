import { expect, it } from "vitest";
import { RecentHistory, WholeHistory } from "../../../src/panel/history";

it("a strip keeps the latest points", () => {
  const history = new RecentHistory(3);
  for (let time = 0; time < 10; time++) history.add(time, time);
  expect(history.values).toEqual([7, 8, 9]);
  history.clear();
  expect(history.values).toEqual([]);
});

it("a whole history spans all of its time in a bounded number of equidistant points", () => {
  const history = new WholeHistory(8, 1);
  for (let time = 0; time < 1000; time += 0.5) {
    history.add(time, time);
    expect(history.values.length).toBeLessThanOrEqual(8);
  }
  const [first, second, ...rest] = history.values;
  expect(first).toBe(0);
  expect(rest.at(-1)).toBeGreaterThan(700);
  rest.reduce((before, value) => {
    expect(value - before).toBe(second);
    return value;
  }, second!);
});

it("a whole history that is cleared starts over with small steps", () => {
  const history = new WholeHistory(4, 1);
  for (let time = 0; time < 100; time++) history.add(time, time);
  history.clear();
  history.add(100, 1);
  history.add(101, 2);
  expect(history.values).toEqual([1, 2]);
});
