import "rt-viewer/element";
import { box, plane, quad, scene, sphere } from "rt-viewer";

document.querySelector("rt-viewer")!.scene = scene({
  camera: { position: [0, 1.3, 4.4], target: [0, 0.5, 0], verticalFov: 34 },
  materials: {
    wall: { baseColor: [0.7, 0.7, 0.7], ior: 1 },
    ember: { emission: [9, 3, 0.7] },
    sky: { emission: [0.8, 2.2, 5] },
  },
  objects: [
    plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "wall" }),
    sphere({ center: [-0.55, 0.3, 0.5], radius: 0.3, material: "ember" }),
    quad({ corner: [0.35, 0.15, -0.9], edge1: [1.1, 0, 0.5], edge2: [0, 1.1, 0], material: "sky" }),
    box({ center: [-0.2, 0.55, -0.6], size: [0.5, 1.1, 0.5], rotationY: 25, material: "wall" }),
    box({ center: [0.55, 0.2, 0.35], size: [0.4, 0.4, 0.4], rotationY: -20, material: "wall" }),
  ],
});
