import "rt-viewer/element";
import { box, plane, scene, sphere } from "rt-viewer";

const viewer = document.querySelector("rt-viewer")!;
const slider = document.querySelector("input")!;

function show() {
  const sky = slider.valueAsNumber;
  viewer.scene = scene({
    camera: { position: [1.7, 1.9, 4], target: [-0.35, 0.46, 0.1], verticalFov: 31 },
    materials: { plaster: { baseColor: [0.72, 0.7, 0.67], ior: 1 }, clay: { baseColor: [0.7, 0.32, 0.2], ior: 1 } },
    objects: [
      plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "plaster" }),
      ...[0, 1, 2, 3].map((i) =>
        box({ center: [0.35 * i - 0.9, 0.15 * (i + 1), -0.3], size: [0.35, 0.3 * (i + 1), 1.4], material: "plaster" }),
      ),
      sphere({ center: [-0.75, 0.4, 0.85], radius: 0.4, material: "clay" }),
    ],
    environment: { radiance: [0.95 * sky, sky, 1.08 * sky] },
  });
}

slider.addEventListener("input", show);
show();
