import "rt-viewer/element";
import { metals, plane, scene, sphere, sphereLight } from "rt-viewer";

const steps = [0, 0.2, 0.4, 0.6, 0.8, 1];

document.querySelector("rt-viewer")!.scene = scene({
  camera: { position: [0, 1.1, 6], target: [0, 0.36, 0], verticalFov: 28 },
  materials: {
    floor: { baseColor: [0.55, 0.55, 0.56], ior: 1 },
    ...Object.fromEntries(steps.map((roughness) => [roughness, { baseColor: metals.copper, metallic: 1, roughness }])),
  },
  objects: [
    plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "floor" }),
    ...steps.map((step, i) => sphere({ center: [0.72 * (i - 2.5), 0.33, 0], radius: 0.33, material: String(step) })),
  ],
  lights: [sphereLight({ position: [1.5, 3.5, 3], radius: 0.5, power: [440, 430, 420] })],
  environment: { radiance: [0.3, 0.33, 0.4] },
});
