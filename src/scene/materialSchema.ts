// Surfaces in the scene format.

import * as v from "valibot";
import { strictObject, stringOr } from "./containers";
import { show } from "./describe";
import { finite, fraction, light, nonNegative, numberThat, positive, reflectance, vec2 } from "./numbers";
import { choice, flag } from "./words";

const MASKINGS = ["smith", "schlick-beckmann"] as const;
const ALPHA_MODES = ["opaque", "mask", "blend"] as const;
/** One of the scene's textures and how it lies on a surface. A name alone is the first set of texture coordinates as it is. */
export const TextureReferenceSchema = strictObject({
  /** Name of the texture. */
  texture: v.string((issue) => `expected the name of a texture, got ${show(issue.input)}`),
  /** Which texture coordinates it is looked up with: 0 is the mesh's `uvs`, 1 its `uvs1`. They are scaled, then turned, then moved. */
  uv: v.optional(
    v.picklist([0, 1], (issue) => `expected 0 or 1, got ${show(issue.input)}`),
    0,
  ),
  /** Added to u and v, last. */
  offset: v.optional(vec2, [0, 0]),
  /** Multiplies u and v, first: with 2 the texture is there twice. */
  scale: v.optional(vec2, [1, 1]),
  /** Degrees around (0, 0), counter-clockwise where v points down (KHR_texture_transform). */
  rotation: v.optional(finite, 0),
});

/** A texture by its name, or with its place. */
export const textureReference = stringOr(TextureReferenceSchema, "the name of a texture or an object with one");

/** A surface as in glTF 2.0: metallic-roughness, and what its extensions add. */
export const MaterialSchema = strictObject(
  {
    /** Albedo of a dielectric, reflectance at normal incidence of a metal; each component from 0 to 1. */
    baseColor: v.optional(reflectance, [1, 1, 1]),
    /** From 0 (dielectric) to 1 (metal). */
    metallic: v.optional(fraction, 0),
    /** From 0 (a perfect mirror) to 1; the microfacet α is its square. */
    roughness: v.optional(fraction, 1),
    /** Index of refraction, > 0, of the dielectric part, relative to what is around it; 1 has no highlight, and less is a bubble. */
    ior: v.optional(positive, 1.5),
    /** Radiance in W·sr⁻¹·m⁻², from the front side only, or from both if `doubleSided`. */
    emission: v.optional(light, [0, 0, 0]),
    /** Whether the back emits too. Both sides reflect anyway. */
    doubleSided: flag,
    /** Whether it shows its colour, whatever the light: it reflects nothing, and emits `baseColor` from both sides. */
    unlit: flag,
    /** The masking function of the microfacets: height-correlated Smith, or Schlick's product form. */
    masking: choice(MASKINGS, "smith"),
    /**
     * Gives a rough metal back the light that its microfacets reflect more than once, which glTF drops: with α = 1 and seen
     * from above, 69 % of it. A white metal is then white, to within 1 %, however rough. Costs 0.3 % of the
     * speed of a scene of such metals. In proportion to `metallic`; a dielectric stays as glTF has it. Needs masking "smith".
     * Not reciprocal (Turquin 2019).
     */
    multiscatter: flag,
    /** How much of the surface is there, from 0 to 1, if `alphaMode` is not `"opaque"`. Surfaces with holes emit, but no light is sampled on them. */
    alpha: v.optional(fraction, 1),
    /** `"mask"`: it is there where alpha is `alphaCutoff` or more. `"blend"`: alpha of the light meets it, and the rest passes. */
    alphaMode: choice(ALPHA_MODES, "opaque"),
    /** Of a mask, ≥ 0. */
    alphaCutoff: v.optional(nonNegative, 0.5),
    /** The texture whose colour, sRGB, multiplies `baseColor`, and whose alpha multiplies `alpha`. Textures show on meshes that have `uvs`. */
    baseColorTexture: v.optional(textureReference),
    /** The texture whose green multiplies `roughness` and whose blue multiplies `metallic`; linear. */
    metallicRoughnessTexture: v.optional(textureReference),
    /** The texture whose colour, sRGB, multiplies `emission`. */
    emissionTexture: v.optional(textureReference),
    /** The texture that bends the normal: 0…255 is −1…1 along tangent, bitangent and normal; linear. */
    normalTexture: v.optional(textureReference),
    /** How far along the surface `normalTexture` bends the normal. */
    normalScale: v.optional(finite, 1),

    // Light that passes: KHR_materials_transmission, _volume, _dispersion and _diffuse_transmission.
    /** How much of the light that enters a dielectric passes, coloured by `baseColor`, instead of being scattered below its surface; from 0 to 1. */
    transmission: v.optional(fraction, 0),
    /** The texture whose red multiplies `transmission`; linear. */
    transmissionTexture: v.optional(textureReference),
    /** 0: a thin wall, which light passes straight. More: the surface bounds a solid, in which light is refracted by `ior` and absorbed, however long its real way; metres. */
    thickness: v.optional(nonNegative, 0),
    /** What white light becomes after `attenuationDistance` in the solid; each component from 0 to 1. */
    attenuationColor: v.optional(reflectance, [1, 1, 1]),
    /** In metres, > 0. Without it nothing is absorbed. */
    attenuationDistance: v.optional(positive),
    /** How much `ior` differs between colours: 20 divided by the Abbe number. 0 is none, 0.36 glass, 1 more than most of nature. */
    dispersion: v.optional(nonNegative, 0),
    /** How much of the light that a dielectric scatters below its surface leaves it on the other side; from 0 to 1. */
    diffuseTransmission: v.optional(fraction, 0),
    /** The texture whose alpha multiplies `diffuseTransmission`; linear. */
    diffuseTransmissionTexture: v.optional(textureReference),
    /** The colour of that light, in place of `baseColor`; each component from 0 to 1. */
    diffuseTransmissionColor: v.optional(reflectance, [1, 1, 1]),
    /** The texture whose colour, sRGB, multiplies `diffuseTransmissionColor`. */
    diffuseTransmissionColorTexture: v.optional(textureReference),

    // Other reflections: KHR_materials_specular, _clearcoat, _sheen, _anisotropy and _iridescence.
    /** Strength of a dielectric's reflection, from 0 to 1. */
    specular: v.optional(fraction, 1),
    /** The texture whose alpha multiplies `specular`; linear. */
    specularTexture: v.optional(textureReference),
    /** Colours a dielectric's reflection at normal incidence, which stays ≤ 1. */
    specularColor: v.optional(light, [1, 1, 1]),
    /** The texture whose colour, sRGB, multiplies `specularColor`. */
    specularColorTexture: v.optional(textureReference),
    /** How much of a clear coat, of ior 1.5, lies on the surface; from 0 to 1. Surfaces under a coat emit, but no light is sampled on them. */
    clearcoat: v.optional(fraction, 0),
    /** The texture whose red multiplies `clearcoat`; linear. */
    clearcoatTexture: v.optional(textureReference),
    /** From 0 to 1, as `roughness`. */
    clearcoatRoughness: v.optional(fraction, 0),
    /** The texture whose green multiplies `clearcoatRoughness`; linear. */
    clearcoatRoughnessTexture: v.optional(textureReference),
    /** The texture that bends the coat's normal, which `normalTexture` leaves alone. */
    clearcoatNormalTexture: v.optional(textureReference),
    /** How far along the surface `clearcoatNormalTexture` bends the normal. */
    clearcoatNormalScale: v.optional(finite, 1),
    /** Reflectance of fibres that stand off the surface, as of velvet; each component from 0 to 1. */
    sheenColor: v.optional(reflectance, [0, 0, 0]),
    /** The texture whose colour, sRGB, multiplies `sheenColor`. */
    sheenColorTexture: v.optional(textureReference),
    /** From 0 to 1: how far the fibres are from upright. */
    sheenRoughness: v.optional(fraction, 0),
    /** The texture whose alpha multiplies `sheenRoughness`; linear. */
    sheenRoughnessTexture: v.optional(textureReference),
    /** How far reflections are stretched, as by fine grooves, from 0 to 1. */
    anisotropy: v.optional(fraction, 0),
    /** Degrees from the tangent, counter-clockwise, to the direction in which they are stretched. The grooves run across it. */
    anisotropyRotation: v.optional(finite, 0),
    /** The texture whose red and green, 0…255 for −1…1, are that direction before the rotation, and whose blue multiplies `anisotropy`; linear. */
    anisotropyTexture: v.optional(textureReference),
    /** How much a thin film on the surface colours its reflection, from 0 to 1. */
    iridescence: v.optional(fraction, 0),
    /** The texture whose red multiplies `iridescence`; linear. */
    iridescenceTexture: v.optional(textureReference),
    /** Index of refraction of the film, ≥ 1. */
    iridescenceIor: v.optional(numberThat("a finite number ≥ 1", { min: 1 }), 1.3),
    /** Of the film, in nanometres. */
    iridescenceThickness: v.optional(nonNegative, 400),
    /** The texture whose green is the thickness, from `iridescenceThicknessMinimum` to `iridescenceThickness`; linear. */
    iridescenceThicknessTexture: v.optional(textureReference),
    /** Of the film where the texture is 0, in nanometres. */
    iridescenceThicknessMinimum: v.optional(nonNegative, 100),
  },
  ({ masking, multiscatter }, addIssue) => {
    if (multiscatter && masking === "schlick-beckmann") {
      addIssue(["multiscatter"], 'expected false with masking "schlick-beckmann", got true; use masking "smith"');
    }
  },
);
