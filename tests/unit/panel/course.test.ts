import { expect, it } from "vitest";
import { ErrorCourse } from "../../../src/panel/course";

/** An accumulation whose error falls with the square root of its time, observed every `step` seconds. */
function observed(until: number, step: number): ErrorCourse {
  const course = new ErrorCourse();
  for (let i = 1; i * step <= until; i++) course.observe({ seconds: i * step, error: 1 / Math.sqrt(i * step) });
  return course;
}

it("a course spans all of its time in few points, equidistant in the logarithm", () => {
  const { points } = observed(10_000, 0.1);
  expect(points[0]!.seconds).toBe(0.1);
  expect(points.at(-1)!.seconds).toBeCloseTo(10_000, 6);
  expect(points.length).toBeLessThan(150);
  for (const [i, { seconds }] of points.slice(0, -2).entries()) {
    expect(points[i + 1]!.seconds / seconds).toBeLessThan(1.1 + 0.1 / seconds + 1e-9); // one step more at most
    expect(points[i + 2]!.seconds / seconds).toBeGreaterThan(1.1 - 1e-9);
  }
});

it("its points lie on what was observed", () => {
  for (const { seconds, error } of observed(100, 0.1).points) expect(error).toBe(1 / Math.sqrt(seconds));
});

it("an estimate that is not known, or not new, is no point", () => {
  const course = new ErrorCourse();
  course.observe({ seconds: 0, error: Number.POSITIVE_INFINITY });
  course.observe({ seconds: 1, error: Number.POSITIVE_INFINITY });
  course.observe({ seconds: 2, error: 0.5 });
  course.observe({ seconds: 3, error: 0.5 });
  course.observe({ seconds: 4, error: 0 });
  expect(course.points).toEqual([{ seconds: 2, error: 0.5 }]);
});

it("time that goes back begins a new course", () => {
  const course = observed(10, 1);
  course.observe({ seconds: 0, error: Number.POSITIVE_INFINITY });
  expect(course.points).toEqual([]);
  course.observe({ seconds: 0.5, error: 0.9 });
  expect(course.points).toEqual([{ seconds: 0.5, error: 0.9 }]);
});
