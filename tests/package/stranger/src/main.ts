import "rt-viewer/element";
import { metals, plane, type Scene, scene, sphere, sphereLight } from "rt-viewer";

const spheres: Scene = scene({
  camera: { position: [0, 1.6, 5], target: [0, 0.6, 0], verticalFov: 40 },
  materials: {
    floor: { baseColor: [0.7, 0.7, 0.7], ior: 1 },
    gold: { baseColor: metals.gold, metallic: 1, roughness: 0.3 },
  },
  objects: [
    plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "floor" }),
    sphere({ center: [0, 0.6, 0], radius: 0.6, material: "gold" }),
  ],
  lights: [sphereLight({ position: [2, 4, 2], radius: 0.5, power: [560, 510, 470] })],
  environment: { radiance: [0.15, 0.18, 0.25] },
});

const viewer = document.querySelector("rt-viewer")!;
viewer.scene = spheres;
viewer.addEventListener("ready", ({ detail }) => {
  document.title = `ready after ${detail.milliseconds.toFixed(0)} ms`;
});
