import { type CompiledScene, compileScene } from "../../src/compile/compileScene";
import { LIGHT, MATERIAL, UNBOUNDED } from "../../src/compile/layouts";
import { linkProgram } from "../../src/compile/linkProgram";
import { parseScene } from "../../src/scene/parseScene";
import type { Light, Material, Scene, SceneObject } from "../../src/scene/schema";
import { readStruct } from "./wgslStruct";

/** A scene of these objects and lights; materials are `lambert` (ior 1) and what `materials` adds. */
export function sceneOf(
  objects: readonly SceneObject[],
  lights: readonly Light[] = [],
  materials: Readonly<Record<string, Material>> = {},
): Scene {
  return {
    camera: { position: [0, 1, 5] },
    materials: { lambert: { ior: 1 }, ...materials },
    objects,
    lights,
  };
}

/** Compiles a scene with the default settings, or with others. */
export function compile(scene: Scene, settings: Partial<Parameters<typeof compileScene>[1]> = {}): CompiledScene {
  return compileScene(parseScene(scene), { estimator: "path", sampler: "sobol", lightSamples: 1, ...settings });
}

/** The linked WGSL of a scene. */
export async function wgslOf(scene: Scene, settings: Parameters<typeof compile>[1] = {}): Promise<string> {
  const { sceneModule, features } = compile(scene, settings);
  return linkProgram(sceneModule, features);
}

/** The uniform `scene`, taken apart by the struct that the generated module declares. */
export function unpack({ sceneModule, uniform }: CompiledScene) {
  const view = new DataView(uniform);
  const count = (field: string) => Number(new RegExp(`${field}: array<\\w+, (\\d+)>`).exec(sceneModule)?.[1] ?? 0);
  let offset = 0;
  const take = (bytes: number) => {
    offset += bytes;
    return offset - bytes;
  };
  const vec4 = () => Array.from({ length: 4 }, () => view.getFloat32(take(4), true));
  const list = <T>(field: string, read: () => T) => Array.from({ length: count(field) }, read);
  const struct = (layout: typeof MATERIAL | typeof LIGHT | typeof UNBOUNDED) => () =>
    readStruct(view, take(layout.bytes), Object.entries(layout.fields));

  const environment = vec4();
  const materials = list("materials", struct(MATERIAL));
  const shapes = list("shapes", vec4);
  const anchors = list("anchors", vec4);
  const lights = list("lights", struct(LIGHT));
  const planes = list("planes", struct(UNBOUNDED));
  const hugeSpheres = list("hugeSpheres", struct(UNBOUNDED));
  const slots = list("slots", vec4);
  return { environment, materials, shapes, anchors, lights, planes, hugeSpheres, slots, bytes: offset };
}
