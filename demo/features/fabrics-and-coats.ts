import "rt-viewer/element";
import { mesh, metals, plane, quad, scene, sphere } from "rt-viewer";
import { revolve, squircle } from "../revolve";

/** From pole to pole, a little fuller than an ellipse. */
const half = Array.from({ length: 33 }, (_, i) => {
  const angle = (Math.PI * (i - 16)) / 32;
  return [0.74 * Math.max(Math.cos(angle), 0) ** 0.8, 0.25 + 0.25 * Math.sin(angle)] as const;
});
/** A turned knob: its side, its bevel and its top. */
const knob = [
  [
    [0.5, 0],
    [0.5, 0.34],
  ],
  [
    [0.5, 0.34],
    [0.44, 0.4],
  ],
  [
    [0.44, 0.4],
    [0, 0.4],
  ],
] as const;
const at = (shape: ReturnType<typeof revolve>, [x, z]: readonly [number, number]) => ({
  ...shape,
  positions: shape.positions.map((value, i) => value + [x, 0, z][i % 3]!),
});

document.querySelector("rt-viewer")!.scene = scene({
  camera: { position: [0, 2.4, 4.8], target: [0, 0.46, 0], verticalFov: 30 },
  materials: {
    velvet: { baseColor: [0.12, 0.008, 0.07], sheenColor: [0.95, 0.4, 0.7], sheenRoughness: 0.4 },
    paint: { baseColor: [0.03, 0.16, 0.4], metallic: 0.8, roughness: 0.45, clearcoat: 1 },
    brushed: { baseColor: metals.iron, metallic: 1, roughness: 0.2, anisotropy: 0.85, anisotropyRotation: 90 },
    bubble: { roughness: 0, transmission: 1, iridescence: 1, iridescenceThickness: 420 },
    floor: { baseColor: [0.2, 0.21, 0.23], roughness: 0.6 },
    lamp: { emission: [12, 11.6, 11] },
  },
  objects: [
    sphere({ center: [-1.3, 0.5, 0.1], radius: 0.5, material: "paint" }),
    mesh({ ...at(revolve([half], { outline: squircle(4) }), [0, 0]), material: "velvet" }),
    sphere({ center: [0, 0.86, 0], radius: 0.37, material: "bubble" }),
    mesh({ ...at(revolve(knob), [1.35, 0.2]), material: "brushed" }),
    plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "floor" }),
    quad({ corner: [-3, 2.6, 1.4], edge1: [1.4, 0, -2.4], edge2: [0.9, 1.1, 0.5], material: "lamp" }),
    quad({ corner: [-1, 2.2, -4], edge1: [4, 0, 0], edge2: [0, 1.6, 1.2], material: "lamp" }),
  ],
  environment: { radiance: [0.5, 0.53, 0.58] },
});
