import { afterAll, expect, test } from "vitest";
import { compileScene } from "../../src/compile/compileScene";
import { linkModule, linkProgram } from "../../src/compile/linkProgram";
import { parseScene } from "../../src/scene/parseScene";
import { diagnose, diagnosePipeline, releaseTint } from "../support/tint";
import { LIGHTS, PRIMITIVES, sceneOf } from "./programs";

afterAll(() => releaseTint());

test.each(Object.keys(PRIMITIVES))(
  "what picks %s compiles without a warning, and so does what picks all or nothing",
  async (name) => {
    for (const objects of [[PRIMITIVES[name]!], Object.values(PRIMITIVES), []]) {
      for (const lights of [LIGHTS["no light"]!, LIGHTS["lights of both kinds"]!]) {
        const scene = parseScene(sceneOf(objects, { m: {} }, lights, [1, 1, 1]));
        const { sceneModule, features } = compileScene(scene, { estimator: "path", sampler: "sobol", lightSamples: 1 });
        const wgsl = await linkProgram(sceneModule, features, "pick");
        expect(await diagnose(wgsl)).toEqual([]);
        expect(await diagnosePipeline(wgsl, "pick")).toEqual([]);
      }
    }
  },
);

test.each(["blit", "error"])("the module %s compiles without a warning", async (name) => {
  expect(await diagnose(await linkModule(name))).toEqual([]);
});

test("what does not compile is told with its line", async () => {
  const messages = await diagnose("fn a() -> f32 {\n  return 1u;\n}\n");
  expect(messages.join("\n")).toMatch(/2:3 error: .*\n {4}return 1u;/);
});
