import { type CompiledScene, compileScene } from "../../src/compile/compileScene";
import { LIGHT, TEXTURE } from "../../src/compile/layouts";
import { linkProgram } from "../../src/compile/linkProgram";
import { parseScene } from "../../src/scene/parseScene";
import type { Light, Material, Scene, SceneObject } from "../../src/scene/schema";
import { type Field, layOut, parseStruct, readStruct } from "./wgslStruct";

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

/** The buffer `scene`, taken apart as the struct that the generated module declares: by member, its rows. */
export function unpack({ sceneModule, uniform }: CompiledScene) {
  const view = new DataView(uniform);
  let bytes = 0;
  const members = parseStruct(sceneModule, "Scene").map(([name, type]) => {
    const [, element, count] = /^array<(\w+), (\d+)>$/.exec(type)!;
    const fields = element === "vec4f" ? undefined : fieldsOf(element!, sceneModule);
    const stride = fields ? Math.ceil(layOut(fields).bytes / 16) * 16 : 16;
    const rows = Array.from({ length: Number(count) }, (_, i) => {
      const at = bytes + i * stride;
      if (fields) return readStruct(view, at, fields);
      return Array.from({ length: 4 }, (_, k) => view.getFloat32(at + 4 * k, true));
    });
    bytes += stride * rows.length;
    return [name, rows];
  });
  return { planes: [], hugeSpheres: [], ...Object.fromEntries(members), bytes } as Unpacked;
}

type Vec4 = readonly number[];
type Row = ReturnType<typeof readStruct>;
type Unpacked = {
  readonly [name in "environment" | "shapes" | "anchors" | "slots"]: readonly Vec4[];
} & { readonly [name in "materials" | "lights" | "planes" | "hugeSpheres"]: readonly Row[] } & {
  readonly bytes: number;
};

const STRUCTS: Readonly<Record<string, { readonly fields: Readonly<Record<string, string>> }>> = {
  Light: LIGHT,
  Texture: TEXTURE,
};

/** Of a struct of the shader modules, or of the generated one. */
function fieldsOf(struct: string, sceneModule: string): Field[] {
  const known = STRUCTS[struct];
  return known ? Object.entries(known.fields) : parseStruct(sceneModule, struct);
}
