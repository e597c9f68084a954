import { describe, expect, test } from "vitest";
import { mat4d, type Vec3d, vec3d } from "wgpu-matrix";
import { cameraBasis, rayStart } from "../../../src/renderer/cameraBasis";
import { parseCamera } from "../../../src/scene/parseScene";
import type { Camera } from "../../../src/scene/schema";

const CAMERA = { position: [3, 4, 5], target: [-1, 0.5, 2], up: [0.1, 1, -0.2], verticalFov: 37 } as const;

function basisOf(camera: Camera, aspect = 1.5) {
  return cameraBasis(parseCamera(camera), [0, 0, 0], aspect);
}

/** The unit direction of the ray through image plane coordinates in [-1, 1], y up, as `camera.wgsl` makes it. */
function directionOf({ forward, right, up }: ReturnType<typeof basisOf>, x: number, y: number) {
  return vec3d.normalize([0, 1, 2].map((i) => forward[i]! + x * right[i]! + y * up[i]!));
}

function expectVector(actual: ArrayLike<number>, expected: ArrayLike<number>): void {
  expect(Array.from(actual)).toEqual(Array.from(expected, (component) => expect.closeTo(component, 12)));
}

describe("basis", () => {
  const basis = basisOf(CAMERA);
  const [forward, right, up] = [basis.forward, basis.right, basis.up].map((v) => vec3d.clone(v)) as [
    Vec3d,
    Vec3d,
    Vec3d,
  ];

  test("forward is the unit direction to the target", () => {
    expectVector(forward, vec3d.normalize(vec3d.subtract(CAMERA.target, CAMERA.position)));
    expect(vec3d.length(forward)).toBeCloseTo(1, 14);
  });

  test("the three are orthogonal and right-handed", () => {
    for (const [a, b] of [
      [forward, right],
      [forward, up],
      [right, up],
    ] as const) {
      expect(vec3d.dot(a, b)).toBeCloseTo(0, 14);
    }
    expectVector(vec3d.normalize(vec3d.cross(right, up)), vec3d.negate(forward));
  });

  test("up leans to the side of the camera's up", () => {
    expect(vec3d.dot(up, CAMERA.up)).toBeGreaterThan(0);
  });

  test("the edges are at half the vertical angle, and that times the aspect", () => {
    const halfHeight = Math.tan((CAMERA.verticalFov / 2) * (Math.PI / 180));
    expect(vec3d.length(up)).toBeCloseTo(halfHeight, 14);
    expect(vec3d.length(right)).toBeCloseTo(1.5 * halfHeight, 14);
  });
});

test("the defaults look along −z with y up and 45 degrees", () => {
  const basis = basisOf({ position: [0, 0, 4] }, 1);
  const half = Math.tan(Math.PI / 8);
  expectVector(basis.forward, [0, 0, -1]);
  expectVector(basis.right, [half, 0, 0]);
  expectVector(basis.up, [0, half, 0]);
});

test("the origin is relative to the compiled scene's", () => {
  const camera = parseCamera({ position: [1e9 + 0.25, 2, 3], target: [1e9, 0, 0] });
  expectVector(cameraBasis(camera, [1e9, 1, 1], 1).origin, [0.25, 1, 2]);
});

test.each([
  [0, 0],
  [1, 1],
  [-1, 1],
  [0.3, -0.8],
])("the ray through (%d, %d) is what perspective and lookAt unproject", (x, y) => {
  const aspect = 16 / 9;
  const projection = mat4d.perspective((CAMERA.verticalFov * Math.PI) / 180, aspect, 0.1, 100);
  const view = mat4d.lookAt(CAMERA.position, CAMERA.target, CAMERA.up);
  const point = vec3d.transformMat4([x, y, 0.5], mat4d.inverse(mat4d.multiply(projection, view)));
  const expected = vec3d.normalize(vec3d.subtract(point, CAMERA.position));
  expectVector(directionOf(basisOf(CAMERA, aspect), x, y), expected);
});

test("the length of up and the distance to the target do not matter, however small", () => {
  const expected = basisOf({ position: [0, 0, 1], target: [0, 0, 0], up: [0, 1, 0] });
  for (const size of [1e-12, 1e-6, 1e6]) {
    const basis = basisOf({ position: [0, 0, size], target: [0, 0, 0], up: [0, size, 0] });
    for (const key of ["forward", "right", "up"] as const) expectVector(basis[key], expected[key]);
  }
});

test("an up close to the view's direction still gives a picture", () => {
  const basis = basisOf({ position: [0, 0, 1], target: [0, 0, 0], up: [0, 5e-6, -1] });
  expectVector(basis.up, [0, Math.tan(Math.PI / 8), 0]);
});

test("rays start on a plane clear of the scene, in the same directions", () => {
  const basis = basisOf(CAMERA);
  const { target } = CAMERA;
  const start = rayStart(basis, [{ kind: "sphere", center: [target[0], target[1], target[2]], radius: 0.5 }]);
  const distance = vec3d.distance(CAMERA.position, target);
  expect(start.near).toBeGreaterThan(0.99 * (distance - 0.5));
  expect(start.near).toBeLessThan(distance - 0.5);
  expectVector(start.origin, vec3d.addScaled(CAMERA.position, vec3d.clone(basis.forward), start.near));
  expect(start).toMatchObject({ forward: basis.forward, right: basis.right, up: basis.up });
});

describe("an orthographic camera", () => {
  const CAMERA_UP = { ...CAMERA, orthographicHeight: 3 };

  test("has its edges at half its height, and that times the aspect, in units", () => {
    const { right, up, isOrthographic } = cameraBasis(parseCamera(CAMERA_UP), [0, 0, 0], 1.5, 0.25);
    expect(isOrthographic).toBe(true);
    expect(vec3d.length(up)).toBeCloseTo(6, 14);
    expect(vec3d.length(right)).toBeCloseTo(9, 14);
  });

  test("has rays that in f32 start where the picture says, to the digit, and are parallel", () => {
    const view = cameraBasis(parseCamera(CAMERA_UP), [0, 0, 0], 1.5);
    const start = rayStart(view, []);
    for (const corner of [-1, 1, 0.37]) {
      for (const axis of ["right", "up"] as const) {
        const expected = view[axis].map((component) => Math.fround(corner) * Math.fround(component));
        const offset = start[axis].map((component) => Math.fround(corner) * Math.fround(component));
        expect(offset.map((component) => start.near * component)).toEqual(expected);
        expect(offset.map((component, i) => Math.fround(Math.fround(start.forward[i]!) + component))).toEqual(
          start.forward.map(Math.fround),
        );
      }
    }
  });
});

describe("a lens", () => {
  const lensOf = (fields: object, unitMetres = 1) =>
    cameraBasis(parseCamera({ position: [0, 0, 5], ...fields }), [0, 0, 0], 1, unitMetres).lens;

  test("is focused on the target, in units, or at the distance asked for", () => {
    expect(lensOf({})).toBeUndefined();
    expect(lensOf({ aperture: 0.1 })).toEqual({ radius: 0.1, focus: 5 });
    expect(lensOf({ aperture: 0.1, focusDistance: 3 }, 0.25)).toEqual({ radius: 0.4, focus: 12 });
  });

  test("has finite rays, whatever its aperture and focus", () => {
    for (const aperture of [1e-18, 1, 1e18]) {
      for (const focusDistance of [1e-18, 1, 1e18]) {
        for (const more of [{}, { orthographicHeight: 1e-3 }, { verticalFov: 1e-6 }]) {
          const camera = parseCamera({ position: [0, 0, 5], aperture, focusDistance, ...more });
          const { lens } = rayStart(cameraBasis(camera, [0, 0, 0], 1), []);
          for (const value of lens) expect(Math.abs(value)).toBeLessThan(3e38);
        }
      }
    }
  });
});
