import { describe, expect, it } from "vitest";
import { vec3n } from "wgpu-matrix";
import { orbitBy, panBy, zoomBy, zoomLimitsFor } from "../../../src/element/orbit";
import type { ResolvedCamera } from "../../../src/scene/schema";

const camera: ResolvedCamera = { position: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], verticalFov: 90, aperture: 0 };
const tilted: ResolvedCamera = {
  position: [1, 2, 3],
  target: [-2, 0.5, 1],
  up: [0.3, 1, -0.2],
  verticalFov: 40,
  aperture: 0,
};

const distanceOf = ({ position, target }: ResolvedCamera) => vec3n.distance(position, target);
const elevationOf = ({ position, target, up }: ResolvedCamera) =>
  Math.PI / 2 - vec3n.angle(vec3n.subtract(position, target), up);
const expectNear = (actual: readonly number[], wanted: readonly number[]) => {
  actual.forEach((value, axis) => {
    expect(value).toBeCloseTo(wanted[axis]!, 9);
  });
};

describe("orbitBy", () => {
  it("turns a quarter to the right around up", () => {
    expectNear(orbitBy(camera, Math.PI / 2, 0).position, [5, 0, 0]);
  });

  it("rises by the angle asked for", () => {
    expectNear(orbitBy(camera, 0, Math.PI / 6).position, [0, 2.5, 5 * Math.cos(Math.PI / 6)]);
  });

  it.each([camera, tilted])("comes back to where it was after a full turn", (start) => {
    let moved = start;
    for (let step = 0; step < 360; step++) moved = orbitBy(moved, Math.PI / 180, 0);
    expectNear(moved.position, start.position);
  });

  it("keeps the distance through thousands of steps", () => {
    let moved = tilted;
    for (let step = 0; step < 10_000; step++) moved = orbitBy(moved, Math.sin(step), Math.cos(3 * step) / 10);
    // 10⁴ steps of a few roundings each, 1e-16 relative.
    expect(distanceOf(moved)).toBeCloseTo(distanceOf(tilted), 10);
  });

  it.each([1, -1])("stops short of the pole, direction %d", (direction) => {
    let moved = tilted;
    for (let step = 0; step < 50; step++) moved = orbitBy(moved, 0.01, direction);
    expect(Math.abs(elevationOf(moved))).toBeLessThan(Math.PI / 2 - 0.009);
    expect(Math.abs(elevationOf(moved))).toBeGreaterThan(Math.PI / 2 - 0.011);
  });

  it("leaves a camera that looks straight down its up vector with finite numbers", () => {
    const moved = orbitBy({ ...camera, position: [0, 5, 0] }, 0.1, -0.1);
    expect(moved.position.every(Number.isFinite)).toBe(true);
    expect(distanceOf(moved)).toBeCloseTo(5);
  });
});

describe("zoomBy", () => {
  it("scales the distance and keeps the direction", () => {
    expectNear(zoomBy(camera, 0.5).position, [0, 0, 2.5]);
  });

  it("keeps within limits made for the scene, and above 0", () => {
    const limits = zoomLimitsFor(camera);
    let near = camera;
    let far = camera;
    for (let step = 0; step < 1000; step++) {
      near = zoomBy(near, 0.5, limits);
      far = zoomBy(far, 2, limits);
    }
    expect(distanceOf(near)).toBeCloseTo(0.05);
    expect(distanceOf(far)).toBeCloseTo(500);
  });
});

describe("panBy", () => {
  it("moves what is at the target's distance by the share of the picture's height", () => {
    // 90° at distance 5: the picture is 10 m high, and its content moves right and up as the camera moves left and down.
    const moved = panBy(camera, 0.1, 0.2);
    expectNear(moved.target, [-1, -2, 0]);
    expectNear(moved.position, [-1, -2, 5]);
  });

  it("does not turn the view", () => {
    const moved = panBy(tilted, 0.3, -0.4);
    expectNear(vec3n.subtract(moved.position, moved.target), vec3n.subtract(tilted.position, tilted.target));
  });
});

describe("an orthographic camera", () => {
  const flat: ResolvedCamera = { ...tilted, orthographicHeight: 4 };

  it("zooms by its height and stays where it is, within limits made for the scene's height", () => {
    expect(zoomBy(flat, 0.5)).toEqual({ ...flat, orthographicHeight: 2 });
    const limits = zoomLimitsFor(flat);
    let [near, far] = [flat, flat];
    for (let step = 0; step < 100; step++) [near, far] = [zoomBy(near, 0.5, limits), zoomBy(far, 2, limits)];
    expect([near, far]).toEqual([
      { ...flat, orthographicHeight: 0.04 },
      { ...flat, orthographicHeight: 400 },
    ]);
  });

  it("in place of a perspective one shows a hundredth to a hundred times as much at the target, and the other way round", () => {
    const shown = 2 * distanceOf(tilted) * Math.tan(Math.PI / 9); // at an angle of 40°
    for (const [factor, share] of [
      [1e-6, 1 / 100],
      [1e6, 100],
    ] as const) {
      expect(zoomBy(flat, factor, zoomLimitsFor(tilted, flat)).orthographicHeight).toBeCloseTo(share * shown, 9);
      const distance = (share * flat.orthographicHeight!) / (2 * Math.tan(Math.PI / 9));
      expect(distanceOf(zoomBy(tilted, factor, zoomLimitsFor(flat, tilted)))).toBeCloseTo(distance, 9);
    }
  });

  it("pans by shares of its height, whatever its distance, and turns without changing it", () => {
    for (const z of [5, 500]) {
      const moved = panBy({ ...camera, position: [0, 0, z], orthographicHeight: 4 }, 0.1, 0.2);
      expectNear(moved.target, [-0.4, -0.8, 0]);
    }
    expect(orbitBy(flat, 1, 0.2).orthographicHeight).toBe(4);
    expect(distanceOf(orbitBy(flat, 1, 0.2))).toBeCloseTo(distanceOf(flat), 12);
  });
});

describe("a camera with a lens", () => {
  const lens: ResolvedCamera = { ...camera, aperture: 0.1 };

  it("keeps the target in focus, whatever moves it", () => {
    for (const moved of [zoomBy(lens, 0.3), orbitBy(lens, 1, 0.5), panBy(lens, 0.2, 0.1)]) {
      expect(moved.focusDistance).toBeUndefined();
    }
  });

  it("that says where it focuses keeps what is sharp at the target sharp, also where the zoom ends", () => {
    expect(zoomBy({ ...lens, focusDistance: 5 }, 0.3).focusDistance).toBeCloseTo(1.5, 12);
    const limits = zoomLimitsFor(lens);
    const near = zoomBy({ ...lens, focusDistance: 5 }, 1e-6, limits);
    expect(near.focusDistance).toBeCloseTo(distanceOf(near), 12);
    expect(zoomBy(near, 1e6, limits).focusDistance).toBeCloseTo(500, 9);
    expect(orbitBy({ ...lens, focusDistance: 4 }, 1, 0.5).focusDistance).toBe(4);
  });

  it("and parallel rays focuses where it did when it zooms, because it stays", () => {
    expect(zoomBy({ ...lens, orthographicHeight: 4, focusDistance: 5 }, 0.3).focusDistance).toBe(5);
  });
});

describe("a step that cannot be carried out", () => {
  const { NaN: nan, POSITIVE_INFINITY: infinity } = Number;
  const onTarget = { ...camera, position: camera.target };

  it.each([
    ["not a number", () => orbitBy(camera, nan, 0), camera],
    ["an infinite angle", () => orbitBy(camera, 0, infinity), camera],
    ["an infinite pan", () => panBy(camera, infinity, 0), camera],
    ["a zoom by 0", () => zoomBy(camera, 0), camera],
    ["a zoom by infinity", () => zoomBy(camera, infinity), camera],
    ["a camera on its target", () => orbitBy(onTarget, 1, 1), onTarget],
  ])("gives back the camera as it was: %s", (_, step, wanted) => {
    expect(step()).toBe(wanted);
  });
});
