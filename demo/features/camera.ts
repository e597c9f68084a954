import "rt-viewer/element";
import { box, metals, plane, scene, sphere, sphereLight } from "rt-viewer";

const viewer = document.querySelector("rt-viewer")!;
const slider = document.querySelector("input")!;

slider.addEventListener("input", () => {
  const angle = (slider.valueAsNumber * Math.PI) / 180;
  viewer.camera = { position: [4.6 * Math.sin(angle), 1.7, 4.6 * Math.cos(angle)] };
});

viewer.scene = scene({
  camera: { position: [0, 1.7, 4.6], target: [0, 0.5, 0], verticalFov: 34 },
  materials: {
    stone: { baseColor: [0.62, 0.6, 0.57], ior: 1 },
    gold: { baseColor: metals.gold, metallic: 1, roughness: 0.25 },
  },
  objects: [
    plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "stone" }),
    sphere({ center: [0, 0.4, 0], radius: 0.4, material: "gold" }),
    box({ center: [-0.9, 0.5, -0.4], size: [0.3, 1, 0.3], rotationY: 20, material: "stone" }),
    box({ center: [0.9, 0.3, 0.2], size: [0.3, 0.6, 0.3], rotationY: 50, material: "stone" }),
    box({ center: [0.3, 0.7, -1], size: [0.3, 1.4, 0.3], rotationY: 75, material: "stone" }),
  ],
  lights: [sphereLight({ position: [2.5, 3.5, 2], radius: 0.4, power: [430, 410, 380] })],
  environment: { radiance: [0.18, 0.2, 0.26] },
});
