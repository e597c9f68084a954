import { expect, test } from "vitest";
import type { Vec3 } from "../../src/scene/schema";
import { runProbe } from "../support/probe";
import { createRandom, randomDirection } from "../support/random";
import { CONSISTENT, randomChoices } from "../support/wgsl/choices";
import { wgslFunctions } from "../support/wgsl/evaluate";

const COUNT = 2_000;
const NONE = 0xffffffffn;
const ULP = 2 ** -23;
const MODULES = [
  "constants",
  "minMax",
  "ray",
  "shapes/box",
  "shapes/plane",
  "shapes/quad",
  "shapes/triangle",
  "shapes/sphere",
];

// Each meets a ray, in `box`, by three vectors from the inputs.
const CALLS = {
  box: "boxIntersect(ray, a, abs(b), 0u)",
  turnedBox: "turnedBoxIntersect(ray, a, abs(b), vec2f(0.8, 0.6), 0u)",
  sphere: "sphereIntersect(ray, a, b.x * b.x, 0u)",
  quad: "quadIntersect(ray, a, b, c, cross(b, c), 1.0)",
  triangle: "triangleIntersect(shearOf(ray), a, b, c)",
} as const;

test("functions evaluated on the CPU give what the device gives, up to what WGSL leaves open, seed 1", async () => {
  const random = createRandom(1);
  const vector = (size: number): Vec3 => [0, 0, 0].map(() => Math.fround(size * (2 * random() - 1))) as unknown as Vec3;
  const inputs = new Float32Array(20 * COUNT);
  for (let i = 0; i < COUNT; i++) {
    const d = randomDirection(random).map(Math.fround);
    for (const [k, v] of [vector(2), d, vector(1), vector(1.5), vector(1.5)].entries()) inputs.set(v, 20 * i + 4 * k);
  }
  const names = Object.keys(CALLS);
  const wgsl = `
    import package::shapes::box::{boxIntersect, turnedBoxIntersect};
    import package::shapes::quad::quadIntersect;
    import package::shapes::triangle::{shearOf, triangleIntersect};
    import package::ray::{Ray, makeRay};
    import package::shapes::sphere::sphereIntersect;
    fn meet(call: u32, ray: Ray, a: vec3f, b: vec3f, c: vec3f) -> f32 {
      ${Object.values(CALLS)
        .map((call, k) => `if (call == ${k}u) { return ${call}; }`)
        .join("\n")}
      return 0.0;
    }
    fn vector(i: u32) -> vec3f { return bitcast<vec3f>(inputs[i].xyz); }
    fn probe(i: u32) {
      let ray = makeRay(vector(5u * i), vector(5u * i + 1u), 0xffffffffu);
      for (var call = 0u; call < ${names.length}u; call++) {
        let t = meet(call, ray, vector(5u * i + 2u), vector(5u * i + 3u), vector(5u * i + 4u));
        outputs[${names.length}u * i + call] = vec4u(bitcast<u32>(t), 0u, 0u, 0u);
      }
    }`;
  const outputRows = names.length * COUNT;
  const words = await runProbe({ wgsl, conditions: {}, count: COUNT, inputs, outputRows });
  const found = new Float32Array(words.buffer);

  const meet = wgslFunctions([...MODULES, wgsl.slice(wgsl.indexOf("fn meet"), wgsl.indexOf("fn vector"))]);
  const devices = [
    ...CONSISTENT.map(({ choices }) => choices),
    ...[2, 3, 4].map((seed) => randomChoices(createRandom(seed))),
  ];
  const runs = devices.map(meet);
  const met = names.map(() => 0);
  const different: object[] = [];
  for (let i = 0; i < COUNT; i++) {
    const [o, d, a, b, c] = [0, 1, 2, 3, 4].map(
      (k) => [...inputs.subarray(20 * i + 4 * k, 20 * i + 4 * k + 3)] as unknown as Vec3,
    );
    for (const [call, name] of names.entries()) {
      const device = found[4 * (names.length * i + call)]!;
      const ours = runs.map((run) => run("meet", BigInt(call), run("makeRay", o!, d!, NONE), a!, b!, c!) as number);
      // What other choices could add to the range of these.
      const slack = 4 * (Math.max(...ours) - Math.min(...ours)) + 8 * ULP * Math.abs(device);
      if (device > 0) met[call]!++;
      if (device < Math.min(...ours) - slack || device > Math.max(...ours) + slack)
        different.push({ name, device, ours });
    }
  }
  expect(different).toEqual([]);
  expect(Math.min(...met)).toBeGreaterThan(25);
});
