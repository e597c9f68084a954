import "rt-viewer/element";
import { box, plane, scene, sphere, sphereLight } from "rt-viewer";

document.querySelector("rt-viewer")!.scene = scene({
  camera: { position: [0, 1.2, 4.8], target: [0, 0.75, 0], verticalFov: 32 },
  materials: {
    white: { baseColor: [0.8, 0.8, 0.8], ior: 1 },
    orange: { baseColor: [0.85, 0.28, 0.03], ior: 1 },
    blue: { baseColor: [0.05, 0.22, 0.75], ior: 1 },
  },
  objects: [
    plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "white" }),
    plane({ point: [0, 0, -1], normal: [0, 0, 1], material: "white" }),
    box({ center: [-1, 0.75, 0], size: [0.06, 1.5, 1.6], rotationY: 12, material: "orange" }),
    box({ center: [1, 0.75, 0], size: [0.06, 1.5, 1.6], rotationY: -12, material: "blue" }),
    sphere({ center: [0, 0.45, 0], radius: 0.45, material: "white" }),
  ],
  lights: [sphereLight({ position: [0, 3.6, 2.2], radius: 0.4, power: [420, 410, 400] })],
});
