// The knobs of a material, as data: what each changes, and when it changes anything.

import type { ResolvedMaterial } from "../scene/schema";
import { strengthOf } from "./colors";
import type { FieldKnob } from "./fieldKnobs";

type Matters = (material: ResolvedMaterial) => boolean;

const scatters: Matters = ({ unlit }) => !unlit;
/** In part, at least: of a metal with a texture, some texels may not be metal. */
const isDielectric: Matters = ({ unlit, metallic, metallicRoughnessTexture }) =>
  !unlit && (metallic < 1 || metallicRoughnessTexture !== undefined);
const reflects: Matters = ({ unlit, metallic, ior, specular }) =>
  !unlit && (metallic > 0 || (ior !== 1 && specular > 0));
const isSmooth: Matters = ({ roughness, metallicRoughnessTexture }) =>
  roughness < 1 || metallicRoughnessTexture !== undefined;
const lightPasses: Matters = ({ transmission, diffuseTransmission }) => transmission > 0 || diffuseTransmission > 0;
const hasVolume: Matters = (material) => material.thickness > 0 && lightPasses(material);

/** Whether it has microfacets that mask each other. */
export const hasMasking: Matters = (material) => material.roughness > 0 && reflects(material);

export const SURFACE: readonly FieldKnob[] = [
  { kind: "color", label: "colour", field: "baseColor" },
  { kind: "slider", label: "metallic", field: "metallic", min: 0, max: 1, matters: scatters },
  { kind: "slider", label: "roughness", field: "roughness", min: 0, max: 1, matters: scatters },
  { kind: "slider", label: "ior", field: "ior", min: 1, max: 3, matters: isDielectric },
];

export const EMISSION: readonly FieldKnob[] = [
  {
    ...{ kind: "hue", label: "emission", field: "emission" },
    matters: ({ unlit, emission }) => !unlit && strengthOf(emission) > 0,
  },
  { kind: "strength", label: "radiance", field: "emission", matters: scatters },
];

/** A group of knobs, folded at first. */
export type Effect = {
  readonly title: string;
  readonly matters: Matters;
  readonly knobs: readonly FieldKnob[];
};

// Labels have room for eleven letters.
export const EFFECTS: readonly Effect[] = [
  {
    title: "transmission",
    matters: isDielectric,
    knobs: [
      { kind: "slider", label: "amount", field: "transmission", min: 0, max: 1 },
      {
        ...{ kind: "amount", label: "thickness", field: "thickness" },
        matters: lightPasses,
      },
      { kind: "amount or none", label: "fades over", field: "attenuationDistance", matters: hasVolume },
      {
        ...{ kind: "color", label: "fades to", field: "attenuationColor" },
        matters: (material) => hasVolume(material) && material.attenuationDistance !== undefined,
      },
      {
        ...{ kind: "slider", label: "dispersion", field: "dispersion", min: 0, max: 1 },
        matters: ({ transmission, thickness }) => transmission > 0 && thickness > 0,
      },
    ],
  },
  {
    title: "translucency",
    matters: isDielectric,
    knobs: [
      { kind: "slider", label: "amount", field: "diffuseTransmission", min: 0, max: 1 },
      {
        ...{ kind: "color", label: "colour", field: "diffuseTransmissionColor" },
        matters: ({ diffuseTransmission }) => diffuseTransmission > 0,
      },
    ],
  },
  {
    title: "specular",
    matters: (material) => isDielectric(material) && material.ior !== 1,
    knobs: [
      { kind: "slider", label: "amount", field: "specular", min: 0, max: 1 },
      {
        ...{ kind: "hue", label: "colour", field: "specularColor" },
        matters: ({ specular, specularColor }) => specular > 0 && strengthOf(specularColor) > 0,
      },
      {
        ...{ kind: "strength", label: "strength", field: "specularColor" },
        matters: ({ specular }) => specular > 0,
      },
    ],
  },
  {
    title: "coat",
    matters: scatters,
    knobs: [
      { kind: "slider", label: "amount", field: "clearcoat", min: 0, max: 1 },
      {
        ...{ kind: "slider", label: "roughness", field: "clearcoatRoughness", min: 0, max: 1 },
        matters: ({ clearcoat }) => clearcoat > 0,
      },
    ],
  },
  {
    title: "sheen",
    matters: scatters,
    knobs: [
      { kind: "color", label: "colour", field: "sheenColor" },
      {
        ...{ kind: "slider", label: "roughness", field: "sheenRoughness", min: 0, max: 1 },
        matters: ({ sheenColor }) => strengthOf(sheenColor) > 0,
      },
    ],
  },
  {
    title: "anisotropy",
    matters: (material) => reflects(material) && isSmooth(material),
    knobs: [
      { kind: "slider", label: "amount", field: "anisotropy", min: 0, max: 1 },
      {
        ...{ kind: "slider", label: "rotation", field: "anisotropyRotation", min: -180, max: 180 },
        matters: ({ anisotropy }) => anisotropy > 0,
      },
    ],
  },
  {
    title: "film",
    matters: scatters,
    knobs: [
      { kind: "slider", label: "amount", field: "iridescence", min: 0, max: 1 },
      {
        ...{ kind: "slider", label: "ior", field: "iridescenceIor", min: 1, max: 3 },
        matters: ({ iridescence }) => iridescence > 0,
      },
      {
        ...{ kind: "slider", label: "thickness", field: "iridescenceThickness", min: 0, max: 1200 },
        matters: ({ iridescence }) => iridescence > 0,
      },
    ],
  },
];
