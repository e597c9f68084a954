import { describe, expect, it } from "vitest";
import { parseCameraOrbit, placeOnOrbit } from "../../../src/element/cameraOrbit";
import type { ResolvedCamera } from "../../../src/scene/schema";

const RAD = Math.PI / 180;
const camera: ResolvedCamera = { position: [3, 5, 4], target: [0, 5, 0], up: [0, 1, 0], verticalFov: 45, aperture: 0 };
const AUTO = { azimuthRadians: undefined, elevationRadians: undefined, distance: undefined };

const expectNear = (actual: readonly number[], wanted: readonly number[]) => {
  for (const [axis, value] of wanted.entries()) expect(actual[axis]).toBeCloseTo(value, 9);
};

describe("parseCameraOrbit", () => {
  it("reads azimuth, elevation and distance in their units", () => {
    const orbit = parseCameraOrbit(" 30deg  -0.5rad 250cm ")!;
    expect(orbit.azimuthRadians).toBeCloseTo(30 * RAD);
    expect(orbit.elevationRadians).toBe(-0.5);
    expect(orbit.distance).toBe(2.5);
  });

  it("leaves what is auto to the scene", () => {
    expect(parseCameraOrbit("auto auto 5m")).toEqual({ ...AUTO, distance: 5 });
    expect(parseCameraOrbit("1e1deg auto auto")).toEqual({ ...AUTO, azimuthRadians: 10 * RAD });
  });

  it.each([
    null,
    "",
    "30deg",
    "30deg 15deg",
    "30deg 15deg 5m 1m",
    "30 15 5",
    "30deg 15deg 5deg",
    "30m 15deg 5m",
    "30deg 15deg 0m",
    "30deg 15deg -1m",
    "deg 15deg 5m",
    "NaNdeg 15deg 5m",
    "Infinitydeg 15deg 5m",
    "30deg 15deg 5constructor",
  ])("%j counts as absent", (text) => {
    expect(parseCameraOrbit(text)).toBeUndefined();
  });
});

describe("placeOnOrbit", () => {
  it("azimuth 0 is on the side of +Z, a quarter turn on that of +X", () => {
    expectNear(placeOnOrbit(camera, { azimuthRadians: 0, elevationRadians: 0, distance: 2 }).position, [0, 5, 2]);
    expectNear(
      placeOnOrbit(camera, { azimuthRadians: 90 * RAD, elevationRadians: 0, distance: 2 }).position,
      [2, 5, 0],
    );
  });

  it("elevation raises the camera and keeps its distance", () => {
    const orbit = { azimuthRadians: 0, elevationRadians: 30 * RAD, distance: 2 };
    expectNear(placeOnOrbit(camera, orbit).position, [0, 6, Math.sqrt(3)]);
  });

  it("what is auto stays as it is", () => {
    expectNear(placeOnOrbit(camera, AUTO).position, camera.position);
    expectNear(placeOnOrbit(camera, { ...AUTO, distance: 10 }).position, [6, 5, 8]);
    const { position, ...others } = placeOnOrbit(camera, { ...AUTO, distance: 10 });
    expect(position).toHaveLength(3);
    expect(others).toEqual({ target: camera.target, up: camera.up, verticalFov: 45, aperture: 0 });
  });

  it("stops short of the pole, where there is no horizon", () => {
    const { position } = placeOnOrbit(camera, { azimuthRadians: 0, elevationRadians: Math.PI, distance: 1 });
    expect(position[1]).toBeLessThan(6);
    expect(position[2]).toBeCloseTo(Math.sin(0.01));
  });

  it("azimuth 0 is on the side of −Y where Z is up", () => {
    const zUp: ResolvedCamera = { ...camera, up: [0, 0, 2] };
    expectNear(placeOnOrbit(zUp, { azimuthRadians: 0, elevationRadians: 0, distance: 1 }).position, [0, 4, 0]);
  });

  it("a camera on its target has no direction and stays", () => {
    const stuck = { ...camera, position: camera.target };
    expect(placeOnOrbit(stuck, { ...AUTO, distance: 3 })).toBe(stuck);
  });

  it("a focus that is given keeps its share of the distance", () => {
    const focused = { ...camera, focusDistance: 4 };
    expect(placeOnOrbit(focused, { ...AUTO, distance: 10 }).focusDistance).toBeCloseTo(8, 12); // from 5 m
    expect(placeOnOrbit(focused, AUTO).focusDistance).toBe(4);
    expect(placeOnOrbit(camera, { ...AUTO, distance: 10 })).not.toHaveProperty("focusDistance");
  });
});
