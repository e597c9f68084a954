import "rt-viewer/element";
import { box, plane, scene, sphere, sphereLight } from "rt-viewer";

const viewer = document.querySelector("rt-viewer")!;
const slider = document.querySelector("input")!;

function show() {
  viewer.scene = scene({
    camera: { position: [0, 1.9, 4.6], target: [0.1, 0.42, 0], verticalFov: 34 },
    materials: { chalk: { baseColor: [0.75, 0.74, 0.72], ior: 1 } },
    objects: [
      plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "chalk" }),
      box({ center: [0.5, 0.6, -0.2], size: [0.28, 1.2, 0.28], rotationY: 30, material: "chalk" }),
      sphere({ center: [-0.45, 0.38, 0.3], radius: 0.38, material: "chalk" }),
    ],
    lights: [sphereLight({ position: [3, 3.2, 1.6], radius: slider.valueAsNumber, power: [700, 660, 610] })],
    environment: { radiance: [0.16, 0.17, 0.2] },
  });
}

slider.addEventListener("input", show);
show();
