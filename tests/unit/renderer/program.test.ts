import { expect, test } from "vitest";
import { programKey } from "../../../src/renderer/program";
import { plane, sphere } from "../../../src/scene/builders";
import { compile, sceneOf } from "../../support/compiled";

const ball = (radius: number) => sphere({ center: [0, 0, 0], radius, material: "lambert" });

test("scenes that differ in values share a program", () => {
  expect(programKey(compile(sceneOf([ball(1)])))).toBe(programKey(compile(sceneOf([ball(2)]))));
});

test("scenes that differ in generated text or in conditions alone do not", () => {
  const one = compile(sceneOf([ball(1)]));
  const floor = plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "lambert" });
  expect(programKey(compile(sceneOf([ball(1), floor])))).not.toBe(programKey(one));
  const independent = compile(sceneOf([ball(1)]), { sampler: "independent" });
  expect(independent.sceneModule).toBe(one.sceneModule);
  expect(programKey(independent)).not.toBe(programKey(one));
});
