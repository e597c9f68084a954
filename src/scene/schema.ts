// The scene format: what is allowed, every default, and the types, which are inferred from it.
//
// Right-handed, Y up, metres; colours are linear Rec. 709; angles are in degrees.

import * as v from "valibot";
import { byType, dictionary, list, strictObject, triple } from "./containers";
import { show } from "./describe";
import { MaterialSchema, type textureReference } from "./materialSchema";
import { checkNames } from "./names";
import {
  bytes,
  coordinates,
  direction,
  finite,
  floats,
  fractions,
  indices,
  light,
  nonNegative,
  numberThat,
  positive,
  sizes,
  vec3,
} from "./numbers";
import { choice } from "./words";

/** A point or a direction, `[x, y, z]`. */
export type Vec3 = readonly [number, number, number];
/** A colour, `[r, g, b]`, linear Rec. 709. */
export type Rgb = readonly [number, number, number];

// Two directions whose angle has a smaller sine count as parallel: in f32 their cross product is mostly rounding error.
const MIN_SINE = 1e-6;
// WebGPU devices have textures of this size; texels of ours are in a buffer, but nothing larger is a picture.
const MAX_TEXTURE_SIZE = 16384;
// A bound for loops; with an albedo of 0.99, 1024 bounces leave 3e-5 of the light.
const MAX_BOUNCES = 1024;

/** Where the scene is seen from, and how. */
export const CameraSchema = strictObject(
  {
    /** Where the rays start: the middle of the lens or, of an orthographic camera, of the plane where they start. */
    position: vec3,
    /** The point in the middle of the picture. */
    target: v.optional(vec3, [0, 0, 0]),
    /** Any direction that points up in the picture; need not be orthogonal to the view. */
    up: v.optional(direction, [0, 1, 0]),
    /** The angle between the lower and the upper edge of the picture, in degrees. */
    verticalFov: v.optional(numberThat("an angle between 0 and 180 degrees", { above: 0, below: 180 }), 45),
    /**
     * From the lower to the upper edge of the picture, in metres. With it the camera is orthographic: its rays are parallel, and
     * `verticalFov` has no meaning.
     */
    orthographicHeight: v.optional(positive),
    /** Radius of the lens, in metres. 0 is a pinhole: all is sharp. */
    aperture: v.optional(nonNegative, 0),
    /** From the position to the plane across the view in which all is sharp, in metres. Default: the target lies in it. */
    focusDistance: v.optional(positive),
  },
  ({ position, target, up }, addIssue) => {
    if (!position || !target) return;
    const view = subtract(target, position);
    if (Math.hypot(...view) === 0) addIssue(["target"], `expected a point other than position, got ${show(target)}`);
    else if (up && areParallel(view, up)) {
      addIssue(["up"], `expected a direction that is not parallel to the view, got ${show(up)}`);
    }
  },
);

const WRAPS = ["repeat", "mirror", "clamp"] as const;
const FILTERS = ["linear", "nearest"] as const;

/** The name of one of the scene's materials. */
const materialName = v.string((issue) => `expected the name of a material, got ${show(issue.input)}`);

/** In texels. */
const textureSize = numberThat(`an integer from 1 to ${MAX_TEXTURE_SIZE}`, {
  min: 1,
  max: MAX_TEXTURE_SIZE,
  isInteger: true,
});

/** A picture for materials. How it is read, as colour or as data, is up to the material. */
export const TextureSchema = strictObject(
  {
    width: textureSize,
    height: textureSize,
    /**
     * Red, green, blue and alpha, from 0 to 255, of each texel; rows from the top. A `Uint8Array` that a
     * loader made, or that comes from a scene that was parsed, is not copied: another picture has to be another array.
     */
    texels: bytes,
    /** What is left and right of it: texture coordinates outside of 0…1 … */
    wrapU: choice(WRAPS, "repeat"),
    /** … and above and below. */
    wrapV: choice(WRAPS, "repeat"),
    /** Between texels. */
    filter: choice(FILTERS, "linear"),
  },
  ({ width, height, texels }, addIssue) => {
    if (!width || !height || !texels || texels.length === 4 * width * height) return;
    addIssue(["texels"], `expected ${4 * width * height} numbers, four per texel, got ${texels.length}`);
  },
);

/** Something with a surface. Front sides matter for emission only: both sides reflect. */
export const ObjectSchema = byType({
  /** A ball. */
  sphere: strictObject({
    type: v.literal("sphere"),
    /** Its middle, `[x, y, z]`. */
    center: vec3,
    /** In metres, > 0. */
    radius: positive,
    material: materialName,
  }),

  /** An infinite plane. */
  plane: strictObject({
    type: v.literal("plane"),
    /** Any of its points, `[x, y, z]`. */
    point: vec3,
    /** The direction its front looks, `[x, y, z]` of any length. */
    normal: direction,
    material: materialName,
  }),

  /** A parallelogram; its front is on the side of edge1 × edge2. */
  quad: strictObject(
    {
      type: v.literal("quad"),
      /** Where its two edges start, `[x, y, z]`. */
      corner: vec3,
      /** From the corner to one of its neighbours, `[x, y, z]`. */
      edge1: direction,
      /** From the corner to its other neighbour, `[x, y, z]`. */
      edge2: direction,
      material: materialName,
    },
    ({ edge1, edge2 }, addIssue) => {
      if (edge1 && edge2 && areParallel(edge1, edge2)) {
        addIssue(["edge2"], `expected a direction that is not parallel to edge1, got ${show(edge2)}`);
      }
    },
  ),

  /** A triangle; its front is where the vertices run counter-clockwise. One without area is allowed and never hit. */
  triangle: strictObject({
    type: v.literal("triangle"),
    /** Three points, each `[x, y, z]`. */
    vertices: triple(vec3, "[a, b, c]"),
    material: materialName,
  }),

  /** A cuboid, upright, turned around the Y axis. */
  box: strictObject({
    type: v.literal("box"),
    /** Its middle, `[x, y, z]`. */
    center: vec3,
    /** Along its own x, y and z, in metres, each > 0. */
    size: sizes,
    /** Degrees around the Y axis through the center, counter-clockwise from above. */
    rotationY: v.optional(finite, 0),
    material: materialName,
  }),

  /** Triangles that share vertices. */
  mesh: strictObject(
    {
      type: v.literal("mesh"),
      /** x, y, z of each vertex. */
      positions: coordinates,
      /** Three vertices per triangle; its front is where they run counter-clockwise. */
      indices,
      /** x, y, z per vertex, of any length. Without them the mesh is faceted. */
      normals: v.optional(floats),
      /** u, v per vertex: where it is on the material's textures; (0, 0) is their top left corner, (1, 1) the bottom right. */
      uvs: v.optional(floats),
      /** A second set, for textures that ask for it by `uv: 1`. */
      uvs1: v.optional(floats),
      /** Red, green, blue and alpha per vertex, from 0 to 1, linear: they multiply the material's `baseColor` and `alpha`. */
      colors: v.optional(fractions),
      /**
       * x, y, z per vertex, along growing u of the normal texture, and ±1: which way its v falls (glTF 2.0, 3.7.2.1). Without them, and
       * where they are zero, the texture coordinates tell. They need `normals`.
       */
      tangents: v.optional(floats),
      material: materialName,
    },
    ({ positions, indices, normals, uvs, uvs1, colors, tangents }, addIssue) => {
      if (positions && positions.length % 3 !== 0) {
        addIssue(["positions"], `expected three numbers per vertex, got ${positions.length} numbers`);
      }
      if (indices && indices.length % 3 !== 0) {
        addIssue(["indices"], `expected three indices per triangle, got ${indices.length} indices`);
      }
      if (positions && normals && normals.length !== positions.length) {
        addIssue(["normals"], `expected as many numbers as positions (${positions.length}), got ${normals.length}`);
      }
      for (const [name, values] of Object.entries({ uvs, uvs1 })) {
        if (!positions || !values || values.length / 2 === positions.length / 3) continue;
        const message = `expected two numbers per vertex (${(2 * positions.length) / 3}), got ${values.length}`;
        addIssue([name as "uvs" | "uvs1"], message);
      }
      for (const [name, values] of Object.entries({ colors, tangents })) {
        if (!positions || !values || values.length / 4 === positions.length / 3) continue;
        const message = `expected four numbers per vertex (${(4 * positions.length) / 3}), got ${values.length}`;
        addIssue([name as "colors" | "tangents"], message);
      }
      if (!positions || !indices) return;
      const vertexCount = Math.floor(positions.length / 3);
      const i = indices.findIndex((index) => index >= vertexCount);
      if (i >= 0)
        addIssue(["indices", i], `expected an index of one of the ${vertexCount} vertices, got ${indices[i]}`);
    },
  ),
});

/** A lamp. */
export const LightSchema = byType({
  /** A lamp without size that shines equally in all directions. */
  point: strictObject({
    type: v.literal("point"),
    /** Where it is, `[x, y, z]`. */
    position: vec3,
    /** In watts, `[r, g, b]`; the intensity is power / 4π. */
    power: light,
  }),

  /** A visible, black ball that emits. */
  sphere: strictObject({
    type: v.literal("sphere"),
    /** Its middle, `[x, y, z]`. */
    position: vec3,
    /** In metres, > 0. Changes the shadow, never the power. */
    radius: positive,
    /** In watts, `[r, g, b]`. */
    power: light,
  }),

  /** A lamp that shines into a cone: fully up to the inner angle, and less and less from there to the outer one. */
  spot: strictObject(
    {
      type: v.literal("spot"),
      /** Where it is, `[x, y, z]`. */
      position: vec3,
      /** The axis of its cone, `[x, y, z]` of any length: where its light goes. */
      direction,
      /** All that leaves it, in watts, `[r, g, b]`. It has this or `intensity`. */
      power: v.optional(light),
      /** Within the inner cone, in W/sr, `[r, g, b]`. */
      intensity: v.optional(light),
      /** Degrees from the axis. In between, intensity goes as the square of what is linear in the cosine, as in glTF. */
      innerAngle: v.optional(numberThat("an angle from 0 to less than 90 degrees", { min: 0, below: 90 }), 0),
      /** Degrees from the axis, more than `innerAngle`. */
      outerAngle: v.optional(numberThat("an angle from 0.001 to 90 degrees", { min: 1e-3, max: 90 }), 45),
      /**
       * Of a disk across the axis that shines, in metres. It softens the shadows, and never changes the power. The disk is not seen, neither
       * by the camera nor in mirrors.
       */
      radius: v.optional(nonNegative, 0),
    },
    (fields, addIssue) => {
      const { innerAngle, outerAngle } = fields;
      if (!("power" in fields || "intensity" in fields)) addIssue(["power"], "expected this or intensity, got neither");
      if ("power" in fields && "intensity" in fields) addIssue(["intensity"], "expected this or power, got both");
      if (innerAngle !== undefined && outerAngle !== undefined && innerAngle >= outerAngle) {
        addIssue(["innerAngle"], `expected an angle less than outerAngle (${outerAngle}), got ${innerAngle}`);
      }
    },
  ),

  /** A sun: parallel light from infinitely far away. */
  directional: strictObject({
    type: v.literal("directional"),
    /** Where its light goes, `[x, y, z]` of any length. */
    direction,
    /** On a surface that faces it, in W/m², `[r, g, b]`. */
    irradiance: light,
    /**
     * Of its disk in the sky, in degrees; 0.53 of the sun. It softens the shadows, and never changes the irradiance. Rays that leave the
     * scene find the disk: the camera and mirrors show it. 0, or less than 0.001, is a point, which nothing shows.
     */
    angularDiameter: v.optional(numberThat("an angle from 0 to less than 180 degrees", { min: 0, below: 180 }), 0),
  }),
});

/** What is behind everything. */
export const EnvironmentSchema = strictObject({
  /** The same from everywhere, in W·sr⁻¹·m⁻². */
  radiance: v.optional(light, [0, 0, 0]),
});

/** A scene. Right-handed, Y up, metres; colours are linear Rec. 709; angles are in degrees. */
export const SceneSchema = v.pipe(
  strictObject(
    {
      /** For editors that check JSON while it is written; has no meaning here. */
      $schema: v.optional(v.string((issue) => `expected the address of a JSON schema, got ${show(issue.input)}`)),
      camera: CameraSchema,
      /** Surfaces by name; the objects refer to them. */
      materials: v.optional(dictionary(MaterialSchema), {}),
      /** Pictures by name; the materials refer to them. */
      textures: v.optional(dictionary(TextureSchema), {}),
      /** Everything that has a surface. */
      objects: list(ObjectSchema),
      /** Lamps; surfaces whose material has an `emission` shine too. */
      lights: v.optional(list(LightSchema), []),
      environment: v.optional(EnvironmentSchema, {}),
      /** How often a path may scatter between camera and light: 0 shows emitters only, 1 is direct light. */
      maxBounces: v.optional(
        numberThat(`an integer from 0 to ${MAX_BOUNCES}`, { min: 0, max: MAX_BOUNCES, isInteger: true }),
        8,
      ),
    },
    checkNames,
  ),
  v.transform(({ $schema, ...scene }) => scene),
);

export { MaterialSchema, TextureReferenceSchema } from "./materialSchema";
export { TEXTURE_FIELDS, type TextureField } from "./names";

/** What users write: everything that has a default is optional. */
export type Scene = v.InferInput<typeof SceneSchema>;
/** Where a scene is seen from, as users write it. */
export type Camera = v.InferInput<typeof CameraSchema>;
/** A surface, as users write it; every field has a default. */
export type Material = v.InferInput<typeof MaterialSchema>;
/** A picture for materials, as users write it. */
export type Texture = v.InferInput<typeof TextureSchema>;
/** One of the scene's textures and how it lies on a surface, as users write it. */
export type TextureReference = v.InferInput<typeof textureReference>;
/** One of the things in a scene, told apart by `type`. */
export type SceneObject = v.InferInput<typeof ObjectSchema>;
/** A lamp, as users write it, told apart by `type`. */
export type Light = v.InferInput<typeof LightSchema>;
/** What is behind everything, as users write it. */
export type Environment = v.InferInput<typeof EnvironmentSchema>;

/** A valid scene with every default filled in, the output of `parseScene`. */
export type ResolvedScene = v.InferOutput<typeof SceneSchema>;
/** A valid camera with every default filled in. */
export type ResolvedCamera = v.InferOutput<typeof CameraSchema>;
export type ResolvedMaterial = v.InferOutput<typeof MaterialSchema>;
export type ResolvedTexture = v.InferOutput<typeof TextureSchema>;
export type ResolvedObject = v.InferOutput<typeof ObjectSchema>;
export type ResolvedLight = v.InferOutput<typeof LightSchema>;

function subtract(a: Vec3, b: Vec3): Vec3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

function areParallel(a: Vec3, b: Vec3): boolean {
  const cross = Math.hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  return cross <= MIN_SINE * Math.hypot(...a) * Math.hypot(...b);
}
