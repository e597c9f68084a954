import type { Camera, Light, Material, Scene, SceneObject } from "./schema";

type ObjectOf<Type extends SceneObject["type"]> = Extract<SceneObject, { readonly type: Type }>;
type LightOf<Type extends Light["type"]> = Extract<Light, { readonly type: Type }>;

// Each builder only adds `type`. Nothing is checked here: `parseScene` does that, once, for the whole scene.

/** A ball: `sphere({ center: [0, 1, 0], radius: 1, material: "red" })`. */
export const sphere = (fields: Omit<ObjectOf<"sphere">, "type">): ObjectOf<"sphere"> => ({ type: "sphere", ...fields });

/** An infinite plane through `point`. */
export const plane = (fields: Omit<ObjectOf<"plane">, "type">): ObjectOf<"plane"> => ({ type: "plane", ...fields });

/** A parallelogram; its front is on the side of edge1 × edge2. */
export const quad = (fields: Omit<ObjectOf<"quad">, "type">): ObjectOf<"quad"> => ({ type: "quad", ...fields });

/** A triangle; its front is where the vertices run counter-clockwise. */
export const triangle = (fields: Omit<ObjectOf<"triangle">, "type">): ObjectOf<"triangle"> => ({
  type: "triangle",
  ...fields,
});

/** A cuboid, turned around the Y axis by `rotationY` degrees. */
export const box = (fields: Omit<ObjectOf<"box">, "type">): ObjectOf<"box"> => ({ type: "box", ...fields });

/** Triangles that share vertices; flat numbers, three per position and three indices per triangle. */
export const mesh = (fields: Omit<ObjectOf<"mesh">, "type">): ObjectOf<"mesh"> => ({ type: "mesh", ...fields });

/** A light without size; power in watts. */
export const pointLight = (fields: Omit<LightOf<"point">, "type">): LightOf<"point"> => ({ type: "point", ...fields });

/** A visible ball of light; power in watts, whatever its radius. */
export const sphereLight = (fields: Omit<LightOf<"sphere">, "type">): LightOf<"sphere"> => ({
  type: "sphere",
  ...fields,
});

/** A lamp that shines into a cone; power in watts or intensity in W/sr, and the angles in degrees from its axis. */
export const spotLight = (fields: Omit<LightOf<"spot">, "type">): LightOf<"spot"> => ({ type: "spot", ...fields });

/** A sun: light from infinitely far away, in W/m² on a surface that faces it. `angularDiameter: 0.53` gives it the sun's soft shadows. */
export const directionalLight = (fields: Omit<LightOf<"directional">, "type">): LightOf<"directional"> => ({
  type: "directional",
  ...fields,
});

/** A material, to be put under its name in `materials`. `material()` is matte white. */
export const material = (fields: Material = {}): Material => fields;

/** A camera, with editor help while it is written. */
export const camera = (fields: Camera): Camera => fields;

/** A scene, with editor help while it is written. Not checked; `parseScene` does that. */
export const scene = (fields: Scene): Scene => fields;
