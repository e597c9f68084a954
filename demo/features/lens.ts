import "rt-viewer/element";
import { plane, scene, sphere, sphereLight } from "rt-viewer";

const viewer = document.querySelector("rt-viewer")!;
const [focus, aperture] = document.querySelectorAll("input");

const lens = () => ({ focusDistance: focus!.valueAsNumber, aperture: aperture!.valueAsNumber });

for (const slider of [focus!, aperture!]) {
  slider.addEventListener("input", () => {
    viewer.camera = lens();
  });
}

const colors = ["red", "amber", "jade", "blue"];

viewer.scene = scene({
  camera: { position: [-0.05, 0.09, 0.44], target: [0, 0.02, -0.06], verticalFov: 25, ...lens() },
  materials: {
    slate: { baseColor: [0.22, 0.23, 0.25], ior: 1 },
    red: { baseColor: [0.7, 0.05, 0.04], roughness: 0.35 },
    amber: { baseColor: [0.85, 0.42, 0.04], roughness: 0.35 },
    jade: { baseColor: [0.05, 0.42, 0.25], roughness: 0.35 },
    blue: { baseColor: [0.05, 0.16, 0.6], roughness: 0.35 },
  },
  objects: [
    plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "slate" }),
    ...Array.from({ length: 7 }, (_, i) =>
      sphere({ center: [0.04 * i - 0.1, 0.02, 0.1 - 0.07 * i], radius: 0.02, material: colors[i % 4]! }),
    ),
  ],
  lights: [sphereLight({ position: [-0.3, 0.4, 0.25], radius: 0.1, power: [9.5, 9, 8.3] })],
  environment: { radiance: [0.3, 0.34, 0.42] },
});
