import { describe, expect, test } from "vitest";
import { firstSight } from "../../../src/loaders/firstSight";
import type { Mesh } from "../../../src/scene/meshes";
import type { Camera } from "../../../src/scene/schema";

/** A square across the z axis, from −1 to 1 along x and y. */
function square(z: number, side = 2): Mesh {
  const positions = [-1, -1, 1, -1, 1, 1, -1, 1].flatMap((place, i) =>
    i % 2 ? [(place * side) / 2, z] : (place * side) / 2,
  );
  return { type: "mesh", positions, indices: [0, 1, 2, 0, 2, 3], material: "m" };
}

describe("an orthographic camera sees", () => {
  // Sixteen pixels over four metres.
  const camera: Camera = { position: [0, 0, 5], orthographicHeight: 4 };

  test.each([4.9, 0, -5000])("a square of half the height in a quarter of the pixels, at z = %d", (z) => {
    const seen = firstSight(camera, [square(z)]);
    expect(seen).toHaveLength(64);
    for (const { point, normal, isFront } of seen) {
      for (const axis of [0, 1] as const) {
        const place = point[axis] * 4 + 0.5; // in pixels of a quarter of a metre, whose middles are whole numbers
        expect(Math.abs(place - Math.round(place))).toBeLessThan(0.01);
      }
      expect(point[2]).toBeCloseTo(z, 9);
      expect(normal[2]).toBe(1);
      expect(isFront).toBe(true);
    }
  });

  test("what is nearer before what is behind it, and nothing behind itself", () => {
    const [near, far, behind] = [square(1), square(0, 10), square(6)];
    const seen = firstSight(camera, [far, near, behind]);
    expect(seen).toHaveLength(256);
    expect(seen.filter(({ mesh }) => mesh === near)).toHaveLength(64);
    expect(seen.filter(({ mesh }) => mesh === behind)).toEqual([]);
  });
});
