import "rt-viewer/element";
import { plane, quad, scene, sphere, sphereLight } from "rt-viewer";

document.querySelector("rt-viewer")!.scene = scene({
  camera: { position: [0, 1.5, 4.8], target: [0, 0.6, 0], verticalFov: 32 },
  materials: {
    floor: { baseColor: [0.62, 0.6, 0.57], ior: 1 },
    mirror: { baseColor: [0.96, 0.96, 0.96], metallic: 1, roughness: 0 },
    red: { baseColor: [0.75, 0.08, 0.05], roughness: 0.5 },
    yellow: { baseColor: [0.85, 0.6, 0.05], roughness: 0.5 },
  },
  objects: [
    plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "floor" }),
    quad({ corner: [0, 0, -1.3], edge1: [-1.5, 0, 1.5], edge2: [0, 1.7, 0], material: "mirror" }),
    quad({ corner: [0, 0, -1.3], edge1: [1.5, 0, 1.5], edge2: [0, 1.7, 0], material: "mirror" }),
    sphere({ center: [-0.25, 0.3, 0.3], radius: 0.3, material: "red" }),
    sphere({ center: [0.3, 0.2, 0.5], radius: 0.2, material: "yellow" }),
  ],
  lights: [sphereLight({ position: [1, 3.4, 2.6], radius: 0.8, power: [330, 320, 300] })],
  environment: { radiance: [0.3, 0.34, 0.42] },
});
