import "rt-viewer/element";
import { mesh, plane, quad, scene, sphere, sphereLight } from "rt-viewer";

const SIZE = 256;
const LEAVES = 5;

/** Leaves in rows, leaning left and right in turn, and nothing between them. */
const texels = Array.from({ length: SIZE ** 2 }, (_, i) => {
  const [column, row] = [(LEAVES * (i % SIZE)) / SIZE, (LEAVES * Math.floor(i / SIZE)) / SIZE];
  const lean = (Math.floor(column) + Math.floor(row)) % 2 === 0 ? 0.7 : -0.7;
  const [x, y] = [2 * (column % 1) - 1, 2 * (row % 1) - 1];
  const [across, along] = [x * Math.cos(lean) - y * Math.sin(lean), x * Math.sin(lean) + y * Math.cos(lean)];
  const isLeaf = Math.abs(across) < 0.5 * (1 - along ** 2);
  const isRib = Math.abs(across) < 0.04;
  return [isRib ? 150 : 70, isRib ? 170 : 130, 60, isLeaf ? 255 : 0];
}).flat();

document.querySelector("rt-viewer")!.scene = scene({
  camera: { position: [0.4, 1.5, 5], target: [0.1, 0.75, 0], verticalFov: 34 },
  textures: { leaves: { width: SIZE, height: SIZE, texels } },
  materials: {
    leaves: { baseColorTexture: "leaves", alphaMode: "mask", roughness: 0.6 },
    pane: { baseColor: [0.8, 0.05, 0.04], alpha: 0.5, alphaMode: "blend" },
    white: { baseColor: [0.8, 0.8, 0.8], roughness: 0.4 },
    floor: { baseColor: [0.7, 0.68, 0.64], ior: 1 },
  },
  objects: [
    mesh({
      positions: [-1.5, 0, 0.1, 0.2, 0, -0.4, 0.2, 1.7, -0.4, -1.5, 1.7, 0.1],
      indices: [0, 1, 2, 0, 2, 3],
      uvs: [0, 1, 1, 1, 1, 0, 0, 0],
      material: "leaves",
    }),
    quad({ corner: [0.35, 0, 0.5], edge1: [1.1, 0, -0.5], edge2: [0, 1.1, 0], material: "pane" }),
    sphere({ center: [-0.5, 0.35, -0.9], radius: 0.35, material: "white" }),
    sphere({ center: [0.9, 0.3, -0.4], radius: 0.3, material: "white" }),
    plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "floor" }),
  ],
  lights: [sphereLight({ position: [-1.6, 3.6, -3], radius: 0.12, power: [420, 410, 390] })],
  environment: { radiance: [0.35, 0.4, 0.48] },
});
