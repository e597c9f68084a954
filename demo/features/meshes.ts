import "rt-viewer/element";
import { mesh, metals, plane, scene, sphere, sphereLight } from "rt-viewer";
import { torusKnot } from "./torusKnot";

document.querySelector("rt-viewer")!.scene = scene({
  camera: { position: [0, 1.9, 4.6], target: [0.25, 0.68, 0], verticalFov: 34 },
  materials: {
    gold: { baseColor: metals.gold, metallic: 1, roughness: 0.28 },
    white: { baseColor: [0.8, 0.8, 0.8], roughness: 0.4 },
    floor: { baseColor: [0.35, 0.37, 0.4], ior: 1 },
  },
  objects: [
    mesh({ ...torusKnot({ center: [-0.2, 0.85, 0], radius: 0.42, tube: 0.15 }), material: "gold" }),
    sphere({ center: [1.25, 0.4, 0.35], radius: 0.4, material: "white" }),
    plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "floor" }),
  ],
  lights: [sphereLight({ position: [-2, 4, 2.5], radius: 0.7, power: [430, 420, 400] })],
  environment: { radiance: [0.4, 0.45, 0.55] },
});
