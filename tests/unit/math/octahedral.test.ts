import { expect, test } from "vitest";
import { NO_NORMAL, packDirections } from "../../../src/math/octahedral";
import { createRandom, randomDirection } from "../../support/random";

/** As `octahedral` in `shapes/mesh.wgsl`. */
function unpack(word: number): number[] {
  const [x, y] = [(word << 16) >> 16, word >> 16].map((part) => Math.max(part / 32767, -1)) as [number, number];
  const z = 1 - Math.abs(x) - Math.abs(y);
  const folded = [(1 - Math.abs(y)) * (x >= 0 ? 1 : -1), (1 - Math.abs(x)) * (y >= 0 ? 1 : -1)];
  const vector = [...(z >= 0 ? [x, y] : folded), z];
  return vector.map((part) => part / Math.hypot(...vector));
}

test("directions survive to within 7·10⁻⁵, whatever their length, seed 1", () => {
  const random = createRandom(1);
  const axes = [1, -1].flatMap((sign) => [0, 1, 2].map((axis) => [0, 1, 2].map((i) => (i === axis ? sign : 0))));
  for (const direction of [...axes, ...Array.from({ length: 10_000 }, () => randomDirection(random))]) {
    const size = 10 ** (8 * random() - 4);
    const [word] = packDirections(Float32Array.from(direction, (part) => size * part));
    expect(word).not.toBe(NO_NORMAL);
    const difference = unpack(word!).map((part, i) => part - direction[i]!);
    // Half a step of 1/32767 in two coordinates moves the third by both, on a face at least 1/√3 from the middle:
    // √(1 + 1 + 4)·1.53e-5·√3.
    expect(Math.hypot(...difference)).toBeLessThan(6.5e-5);
  }
});

test("zero is no direction", () => {
  expect([...packDirections(new Float32Array(3))]).toEqual([NO_NORMAL]);
});
