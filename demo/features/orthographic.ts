import "rt-viewer/element";
import { box, scene, sphere, sphereLight } from "rt-viewer";

const viewer = document.querySelector("rt-viewer")!;
const checkbox = document.querySelector("input")!;

const height = () => ({ orthographicHeight: checkbox.checked ? 3.6 : undefined });

checkbox.addEventListener("input", () => {
  viewer.camera = height();
});

// Heights of the blocks, row by row, in tenths of a metre.
const town = [
  [9, 5, 11, 5],
  [5, 9, 5, 13],
  [9, 3, 5, 5],
  [5, 5, 3, 5],
];
const towers = town.flatMap((row, z) =>
  row.map((tenths, x) => ({ x: 0.7 * (x - 1.5), z: 0.7 * (z - 1.5), y: tenths / 10 })),
);

viewer.scene = scene({
  camera: { position: [4, 3.53, 4], target: [0, 0.2, 0], verticalFov: 32, ...height() },
  materials: {
    lawn: { baseColor: [0.3, 0.42, 0.2], ior: 1 },
    sand: { baseColor: [0.76, 0.66, 0.5], ior: 1 },
    clay: { baseColor: [0.62, 0.27, 0.17], ior: 1 },
    ink: { baseColor: [0.05, 0.12, 0.4], roughness: 0.3 },
  },
  objects: [
    box({ center: [0, -0.1, 0], size: [3, 0.2, 3], material: "lawn" }),
    ...towers.map(({ x, y, z }) =>
      box({ center: [x, y / 2, z], size: [0.42, y, 0.42], material: y > 0.8 ? "clay" : "sand" }),
    ),
    ...towers
      .filter(({ y }) => y < 0.4)
      .map(({ x, y, z }) => sphere({ center: [x, y + 0.2, z], radius: 0.2, material: "ink" })),
  ],
  lights: [sphereLight({ position: [1, 5.5, 6], radius: 0.6, power: [2600, 2450, 2250] })],
  environment: { radiance: [0.4, 0.45, 0.53] },
});
