import { describe, expectTypeOf, test } from "vitest";
import * as api from "../../src/index";

// Checked by `npm run types`; at run time these only see that the names are there.

describe("scenes", () => {
  test("a scene needs a camera and objects; everything else has a default", () => {
    expectTypeOf({ camera: { position: [0, 0, 1] as const }, objects: [] }).toExtend<api.Scene>();
    expectTypeOf({ objects: [] }).not.toExtend<api.Scene>();
    expectTypeOf<api.Material>().toEqualTypeOf<Partial<api.Material>>();
  });

  test("what is parsed has every default, and can be written again", () => {
    expectTypeOf(api.parseScene).parameters.toEqualTypeOf<[unknown]>();
    expectTypeOf(api.parseScene).returns.toEqualTypeOf<api.ResolvedScene>();
    expectTypeOf<api.ResolvedScene>().toExtend<api.Scene>();
    expectTypeOf<api.ResolvedScene["maxBounces"]>().toEqualTypeOf<number>();
    expectTypeOf<api.ResolvedScene["camera"]["up"]>().toEqualTypeOf<api.Vec3>();
    expectTypeOf<api.ResolvedScene["environment"]["radiance"]>().toEqualTypeOf<api.Rgb>();
  });

  test("vectors are three numbers, and read-only", () => {
    expectTypeOf<api.Vec3>().toEqualTypeOf<readonly [number, number, number]>();
    expectTypeOf<[number, number]>().not.toExtend<api.Vec3>();
    expectTypeOf(api.metals.gold).toEqualTypeOf<api.Rgb>();
  });

  test("objects and lights are told apart by their type", () => {
    expectTypeOf<api.SceneObject["type"]>().toEqualTypeOf<"sphere" | "plane" | "quad" | "triangle" | "box" | "mesh">();
    expectTypeOf<api.Light["type"]>().toEqualTypeOf<"point" | "sphere" | "spot" | "directional">();
    expectTypeOf<Extract<api.SceneObject, { type: "box" }>["rotationY"]>().toEqualTypeOf<number | undefined>();
  });

  test("a builder takes an object without its type", () => {
    expectTypeOf(api.sphere).returns.toExtend<api.SceneObject>();
    expectTypeOf(api.sphereLight).returns.toExtend<api.Light>();
    expectTypeOf(api.sphere).parameter(0).toEqualTypeOf<{
      readonly center: api.Vec3;
      readonly radius: number;
      readonly material: string;
    }>();
  });
});

describe("the tracer", () => {
  test("is made from a scene and a size; a device and settings may be given", () => {
    expectTypeOf(api.PathTracer.create).parameters.toEqualTypeOf<[api.PathTracerOptions]>();
    expectTypeOf(api.PathTracer.create).returns.toEqualTypeOf<Promise<api.PathTracer>>();
    expectTypeOf<api.PathTracerOptions["device"]>().toEqualTypeOf<GPUDevice | undefined>();
    type Needed = Pick<api.PathTracerOptions, "scene" | "width" | "height">;
    expectTypeOf<Needed>().toExtend<api.PathTracerOptions>();
    // @ts-expect-error: it cannot be made without waiting for its device
    expectTypeOf(api.PathTracer).toBeConstructibleWith({});
  });

  test("has the methods of the design", () => {
    expectTypeOf<api.PathTracer["setScene"]>().toEqualTypeOf<
      (scene: api.Scene, options?: api.SceneOptions) => Promise<void>
    >();
    expectTypeOf<api.PathTracer["setCamera"]>().toEqualTypeOf<(camera: api.Camera) => void>();
    expectTypeOf<api.PathTracer["resize"]>().toEqualTypeOf<(width: number, height: number) => void>();
    expectTypeOf<api.PathTracer["update"]>().toEqualTypeOf<(settings: Partial<api.Settings>) => void>();
    expectTypeOf<api.PathTracer["sample"]>().toEqualTypeOf<(count: number) => Promise<void>>();
    expectTypeOf<api.PathTracer["pick"]>().toEqualTypeOf<(x: number, y: number) => Promise<api.Picked | undefined>>();
    expectTypeOf<api.PathTracer["readRadiance"]>().returns.resolves.toExtend<Float32Array>();
    expectTypeOf<api.PathTracer["present"]>().toEqualTypeOf<(context: GPUCanvasContext, view?: api.View) => boolean>();
    expectTypeOf<api.PathTracer["dispose"]>().toEqualTypeOf<() => void>();
  });

  test("its stats are those of the design", () => {
    type Figures =
      | "fps"
      | "frameMs"
      | "gpuMs"
      | "samples"
      | "seconds"
      | "pathsPerSecond"
      | "raysPerSecond"
      | "error"
      | "badSamples";
    expectTypeOf<Pick<api.Stats, Figures>>().toEqualTypeOf<Record<Figures, number>>();
    expectTypeOf<api.Stats["adapter"]>().toEqualTypeOf<string>();
    expectTypeOf<api.Stats["features"]>().toEqualTypeOf<readonly string[]>();
  });

  test("its settings all have defaults", () => {
    expectTypeOf(api.DEFAULT_SETTINGS).toEqualTypeOf<api.Settings>();
    expectTypeOf<api.Settings["estimator"]>().toEqualTypeOf<"path" | "uniform">();
    expectTypeOf<{ readonly sampler: "halton" }>().not.toExtend<Partial<api.Settings>>();
  });
});

test("every error of ours is an RtViewerError; a SceneError lists its issues", () => {
  expectTypeOf<api.SceneError | api.WebGpuError | api.UnsupportedError>().toExtend<api.RtViewerError>();
  expectTypeOf<api.SceneError["issues"]>().toEqualTypeOf<readonly api.SceneIssue[]>();
  expectTypeOf<api.SceneIssue>().toEqualTypeOf<{ readonly path: string; readonly message: string }>();
});
