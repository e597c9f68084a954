import type { Light } from "../lights/light";
import { bothSides, isDistant, lightsOf } from "../lights/lights";
import { hasCoat } from "../lobes/clearcoat";
import { hasHoles } from "../lobes/coverage";
import { emitsTwice } from "../lobes/sides";
import type { ResolvedScene } from "../scene/schema";
import { kindOf } from "../shapes/shapes";
import { isEmissive, type Primitive } from "./primitives";

/**
 * Everything that emits and can be sampled, with strengths in proportion to the strongest's: first what lies on primitives, in
 * their order, then lights without a body, those that are infinitely far last.
 */
export function lightsOfScene(scene: ResolvedScene, primitives: readonly Primitive[]): Light[] {
  const lights: Light[] = [];
  for (const [id, primitive] of primitives.entries()) {
    const { shape, emission, material } = primitive;
    if (!isEmissive(primitive) || !shinesAsSaid(material)) continue;
    const front = kindOf(shape).lights(shape, emission, id);
    const sides = material !== "black" && emitsTwice(material) ? front.flatMap(bothSides) : front;
    for (const light of sides) lights.push(light);
  }
  const distant: Light[] = [];
  for (const each of scene.lights) {
    for (const light of lightsOf(each, scene.camera.target)) (isDistant(light) ? distant : lights).push(light);
  }
  for (const light of distant) lights.push(light);
  let strongest = 0;
  for (const { strength } of lights) strongest = Math.max(strongest, strength);
  if (strongest === 0) return lights;
  return lights.map((light) => ({ ...light, strength: light.strength / strongest }));
}

/** Whether what leaves a surface is its emission: not where some of it is missing, nor under a coat. */
function shinesAsSaid(material: Primitive["material"]): boolean {
  return material === "black" || !(hasHoles(material) || hasCoat(material));
}
