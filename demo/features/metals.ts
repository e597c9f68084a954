import "rt-viewer/element";
import { metals, plane, scene, sphere, sphereLight } from "rt-viewer";

const names = Object.keys(metals) as (keyof typeof metals)[];

document.querySelector("rt-viewer")!.scene = scene({
  camera: { position: [0, 1.5, 6], target: [0, 0.38, 0], verticalFov: 28 },
  materials: {
    table: { baseColor: [0.3, 0.3, 0.31], roughness: 0.5 },
    ...Object.fromEntries(names.map((name) => [name, { baseColor: metals[name], metallic: 1, roughness: 0.35 }])),
  },
  objects: [
    plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "table" }),
    ...names.map((name, i) =>
      sphere({ center: [0.62 * (i - 3), 0.29, -0.14 * Math.abs(i - 3)], radius: 0.29, material: name }),
    ),
  ],
  lights: [sphereLight({ position: [-2, 4, 3], radius: 0.9, power: [480, 470, 450] })],
  environment: { radiance: [0.55, 0.57, 0.6] },
});
