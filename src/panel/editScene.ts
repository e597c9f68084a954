import type { ScenePart } from "../scene/parts";
import type { ResolvedLight, ResolvedMaterial, ResolvedObject, ResolvedScene } from "../scene/schema";

/** The same scene with another material of that name; for all objects that are made of it. */
export function withMaterial(scene: ResolvedScene, name: string, material: ResolvedMaterial): ResolvedScene {
  return { ...scene, materials: { ...scene.materials, [name]: material } };
}

/** The same scene with another light in that place. */
export function withLight(scene: ResolvedScene, index: number, light: ResolvedLight): ResolvedScene {
  return { ...scene, lights: scene.lights.with(index, light) };
}

/** Everything that can be chosen: the objects, then the lights. */
export function partsOf({ objects, lights }: ResolvedScene): ScenePart[] {
  return [
    ...[...objects.keys()].map((index) => ({ kind: "object", index }) as const),
    ...[...lights.keys()].map((index) => ({ kind: "light", index }) as const),
  ];
}

/** What a part is called: by its place in the scene, as in error messages, and by what it is. */
export function nameOf({ objects, lights }: ResolvedScene, { kind, index }: ScenePart): string {
  if (kind === "light") return `lights[${index}] · ${lights[index]!.type}`;
  const { type, material } = objects[index]!;
  return `objects[${index}] · ${type} · ${material}`;
}

/** The objects that a change of the material changes too. */
export function objectsOf(scene: ResolvedScene, material: string): ResolvedObject[] {
  return scene.objects.filter((object) => object.material === material);
}
