import "rt-viewer/element";
import { scene, sphere } from "rt-viewer";

const viewer = document.querySelector("rt-viewer")!;
const checkbox = document.querySelector("input")!;
const steps = [0.2, 0.4, 0.6, 0.8, 1];

function show() {
  const white = { baseColor: [1, 1, 1], metallic: 1, multiscatter: checkbox.checked } as const;
  viewer.scene = scene({
    camera: { position: [0, 0, 8], verticalFov: 26 },
    materials: Object.fromEntries(steps.map((roughness) => [roughness, { ...white, roughness }])),
    objects: steps.map((step, i) => sphere({ center: [1.05 * (i - 2), 0, 0], radius: 0.48, material: String(step) })),
    environment: { radiance: [0.6, 0.6, 0.6] },
  });
}

checkbox.addEventListener("change", show);
show();
