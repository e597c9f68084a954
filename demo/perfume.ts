import { box, mesh, metals, quad, type Rgb, type Scene, scene } from "rt-viewer";
import { printedWord } from "./printedWord";
import { arc, revolve, squircle } from "./revolve";

type Curve = readonly (readonly [x: number, y: number])[];

const OUTER = squircle(5);
const [GLASS_IOR, COLOGNE_IOR] = [1.5, 1.36];
const LEVEL = 0.66;
const TOP = 0.9;

/** A bottle of cologne on a studio's curved backdrop. One unit is a decimetre. */
export function perfumeScene(): Scene {
  const cologne = {
    roughness: 0,
    transmission: 1,
    thickness: 1,
    attenuationColor: [0.96, 0.5, 0.16] as Rgb,
    attenuationDistance: 0.6,
  };
  return scene({
    camera: { position: [1.75, 1.35, 4.7], target: [0, 0.68, 0], verticalFov: 22 },
    textures: { print: printedWord("LUMEN") },
    materials: {
      glass: { roughness: 0, ior: GLASS_IOR, transmission: 1, thickness: 1 },
      cologne: { ...cologne, ior: COLOGNE_IOR },
      // Where it touches the glass there is one surface, not two: what bends light there is the index relative to that of glass. So no
      // gap of air shines between them, and the tracer, which has no priorities of nested solids, needs none.
      "cologne in glass": { ...cologne, ior: COLOGNE_IOR / GLASS_IOR },
      "brushed gold": {
        baseColor: [0.93, 0.76, 0.5],
        metallic: 1,
        roughness: 0.28,
        anisotropy: 0.8,
        anisotropyRotation: 90,
      },
      gold: { baseColor: metals.gold, metallic: 1, roughness: 0.12 },
      tube: { baseColor: [0.9, 0.88, 0.84], roughness: 0.3 },
      label: { baseColor: [0.86, 0.83, 0.78], roughness: 0.6, clearcoat: 1, clearcoatRoughness: 0.05 },
      print: { baseColorTexture: "print", roughness: 0.6, clearcoat: 1, clearcoatRoughness: 0.05 },
      paper: { baseColor: [0.26, 0.38, 0.39], ior: 1 },
      window: { emission: [4.4, 4.3, 4.1] },
      strip: { emission: [5, 4.9, 4.8] },
      ceiling: { emission: [3, 2.9, 2.7] },
    },
    objects: [
      ...bottle(),
      ...cap(),
      box({ center: [0, 0.4, 0.506], size: [0.46, 0.3, 0.008], material: "label" }),
      mesh({ ...print(), material: "print" }),
      mesh({ ...backdrop(), material: "paper" }),
      // A wide window on the left, a strip that draws the right edge, and light from above for cap and backdrop.
      quad({ corner: [-1.6, 0.2, 3.2], edge1: [-1.7, 0, -3], edge2: [-0.2, 3, 0], material: "window" }),
      quad({ corner: [2.7, 0.1, -0.7], edge1: [0, 0, 1.6], edge2: [-0.3, 2.8, 0], material: "strip" }),
      quad({ corner: [-2.2, 3.9, -1.8], edge1: [4.4, 0, 0], edge2: [0, 0.5, 2.6], material: "ceiling" }),
    ],
    environment: { radiance: [0.15, 0.155, 0.165] },
    maxBounces: 14,
  });
}

function bottle() {
  const part = (curve: Curve, material: string) =>
    mesh({ ...revolve([curve], { outline: OUTER, segments: 160 }), material });
  // It hovers by a hair: what lies in one plane would be met in either order.
  const foot = 0.003;
  const skin = line([0, foot], ...arc([0.46, foot + 0.04], 0.04, -90, 0), ...arc([0.44, TOP - 0.06], 0.06, 0, 90), [
    0,
    TOP,
  ]);
  const filled = line([0, 0.15], ...arc([0.36, 0.2], 0.05, -90, 0), [0.41, LEVEL]);
  const empty = line([0, TOP - 0.1], ...arc([0.36, TOP - 0.15], 0.05, 90, 0), [0.41, LEVEL]);
  const tube = line([0.014, 0.17], [0.014, TOP]);
  return [
    part(skin, "glass"),
    part(empty, "glass"),
    part(filled, "cologne in glass"),
    part(line([0.41, LEVEL], [0, LEVEL]), "cologne"),
    mesh({ ...revolve([tube], { segments: 24 }), material: "tube" }),
  ];
}

function cap() {
  const collar = line([0.19, TOP], [0.19, TOP + 0.1]);
  const below = line([0, 0.98], [0.225, 0.98]);
  const side = line([0.225, 0.98], ...arc([0.225, 1], 0.015, -60, 0), ...arc([0.225, 1.4], 0.015, 0, 90), [0, 1.415]);
  return [
    mesh({ ...revolve([collar]), material: "gold" }),
    mesh({ ...revolve([below, side]), material: "brushed gold" }),
  ];
}

/** A profile, or a part of one, as `revolve` takes it. */
function line(...points: Curve): Curve {
  return points;
}

/** Paper that hangs from above, turns in a quarter of a circle and lies on the table. */
function backdrop() {
  const radius = 1.8;
  const bend = arc([-1.6, radius], radius, 270, 180, 24);
  const curve = line([6, 0], ...bend, [bend.at(-1)![0], 7]);
  const normals = curve.flatMap(([z, y]) => {
    const normal = [0, Math.max(1 - y / radius, 0), Math.min(Math.max(-1.6 - z, 0) / radius, 1)];
    return [...normal, ...normal];
  });
  return {
    positions: curve.flatMap(([z, y]) => [-9, y, z, 9, y, z]),
    normals,
    indices: curve.slice(1).flatMap((_, i) => [2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 1, 2 * i + 3, 2 * i + 2]),
  };
}

/** The upright rectangle in front of the label, with its picture. */
function print() {
  const [left, right, lower, upper, z] = [-0.23, 0.23, 0.25, 0.55, 0.511];
  return {
    positions: [left, lower, z, right, lower, z, right, upper, z, left, upper, z],
    indices: [0, 1, 2, 0, 2, 3],
    uvs: [0, 1, 1, 1, 1, 0, 0, 0],
  };
}
