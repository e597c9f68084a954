import "rt-viewer/element";
import { mesh, quad, scene, sphere } from "rt-viewer";

const glass = { transmission: 1, thickness: 1, roughness: 0 };
const [CREAM, BLUE] = [
  [236, 226, 206, 255],
  [112, 132, 152, 255],
];

document.querySelector("rt-viewer")!.scene = scene({
  camera: { position: [0.1, 2.1, 5], target: [0, 0.42, 0.1], verticalFov: 28 },
  textures: { tiles: { width: 2, height: 2, filter: "nearest", texels: [CREAM, BLUE, BLUE, CREAM].flat() } },
  materials: {
    amber: { ...glass, attenuationColor: [0.95, 0.45, 0.08], attenuationDistance: 0.5 },
    flint: { ...glass, ior: 1.7, dispersion: 2 },
    frosted: { ...glass, roughness: 0.3 },
    pane: { baseColor: [0.3, 0.75, 0.55], transmission: 1, roughness: 0 },
    floor: { baseColorTexture: "tiles", ior: 1 },
    lamp: { emission: [7, 6.7, 6.3] },
  },
  objects: [
    sphere({ center: [-1.15, 0.5, 0.1], radius: 0.5, material: "amber" }),
    sphere({ center: [0, 0.5, 0.5], radius: 0.5, material: "flint" }),
    sphere({ center: [1.15, 0.5, 0.1], radius: 0.5, material: "frosted" }),
    quad({ corner: [-0.8, 0, -0.75], edge1: [1.6, 0, 0.25], edge2: [0, 1.1, 0], material: "pane" }),
    mesh({
      positions: [-30, 0, 30, 30, 0, 30, 30, 0, -30, -30, 0, -30],
      indices: [0, 1, 2, 0, 2, 3],
      uvs: [0, 0, 75, 0, 75, 75, 0, 75],
      material: "floor",
    }),
    quad({ corner: [-4, 3, -4.4], edge1: [4.4, 0, 0], edge2: [0, 2, 2], material: "lamp" }),
  ],
  environment: { radiance: [0.7, 0.76, 0.84] },
});
