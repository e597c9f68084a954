import { Color, DoubleSide, MeshPhysicalMaterial } from "three";
import type { ResolvedMaterial, Rgb } from "../../../../src/scene/schema";
import { BLACK } from "../../../../src/scene/shown";

/**
 * A material for three-gpu-pathtracer.
 *
 * Its metal is the format's; its dielectric has the exact Fresnel term where the format has Schlick's. A dielectric without
 * a highlight (ior 1) is Lambert's at roughness 0, and Disney's diffuse lobe above.
 *
 * Whatever is rough comes out too dark, for a reason in its shader: the shadow ray starts on the side of the surface to which
 * the path goes on, and a direction sampled from a rough highlight may point below. A metal of roughness 1 loses a fifth,
 * and so would the matte surfaces of a Cornell box lose 9 % at roughness 1, for all that their highlight is black.
 *
 * @throws {Error} naming what the path tracer cannot render.
 */
export function createMaterial(source: ResolvedMaterial): MeshPhysicalMaterial {
  if (source.masking !== "smith") throw unsupported('masking "smith"', source.masking);
  if (source.multiscatter) throw unsupported("multiscatter false", source.multiscatter);
  const isMatte = source.ior === 1 && source.metallic === 0;
  return new MeshPhysicalMaterial({
    color: toColor(source.baseColor),
    metalness: source.metallic,
    roughness: isMatte ? 0 : source.roughness,
    ior: source.ior,
    // The reflectance at grazing angles, too, which Schlick's term makes 1 whatever the index.
    specularIntensity: isMatte ? 0 : 1,
    side: DoubleSide,
  });
}

/** Black, and emits the radiance. */
export function createEmitter(radiance: Rgb): MeshPhysicalMaterial {
  const black = { ...BLACK, roughness: 0, emission: radiance };
  const material = createMaterial(black);
  material.emissive = toColor(radiance);
  return material;
}

/** Linear Rec. 709 is what three.js works in; components may exceed 1. */
export function toColor(rgb: Rgb): Color {
  return new Color().setRGB(...rgb);
}

function unsupported(expected: string, got: unknown): Error {
  return new Error(`three-gpu-pathtracer: expected ${expected}, got ${JSON.stringify(got)}`);
}
