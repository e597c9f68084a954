import {
  DataTexture,
  EquirectangularReflectionMapping,
  FloatType,
  type Light,
  type Material,
  Matrix4,
  Mesh,
  PerspectiveCamera,
  PointLight,
  RectAreaLight,
  RGBAFormat,
  Scene,
  Vector3,
} from "three";
import type { ResolvedLight, ResolvedMaterial, ResolvedObject, ResolvedScene, Rgb } from "../../../../src/scene/schema";
import { createGeometry, createSphere } from "./createGeometry";
import { createEmitter, createMaterial, toColor } from "./createMaterial";

// Rows of the environment: its sampler gets no closer to the poles than half a row.
const ENVIRONMENT_ROWS = 256;
// With more, a path runs out of rows in the texture of random numbers, which has 20.
const MAX_BOUNCES = 18;
// How far the dark quad lies behind the light that shines from it, in edge lengths: out of the way of shadow rays.
const QUAD_SETBACK = 1e-3;

/**
 * Converts a scene for three-gpu-pathtracer, as patched by `patchShader`.
 *
 * It samples quads, points and the environment. Other emitters, sphere lights above all, only its paths can find.
 *
 * @throws {Error} naming what the path tracer cannot render.
 */
export function convertScene(
  scene: ResolvedScene,
  aspect: number,
): { readonly world: Scene; readonly camera: PerspectiveCamera } {
  if (scene.maxBounces > MAX_BOUNCES) throw unsupported(`maxBounces up to ${MAX_BOUNCES}, got ${scene.maxBounces}`);
  const world = new Scene();
  setEnvironment(world, scene.environment.radiance);
  const materials = new Map(Object.entries(scene.materials).map(([name, source]) => [name, createMaterial(source)]));
  for (const object of scene.objects) {
    world.add(...convertObject(object, scene.materials[object.material]!, materials.get(object.material)!));
  }
  for (const light of scene.lights) world.add(convertLight(light));
  return { world, camera: createCamera(scene.camera, aspect) };
}

function createCamera(source: ResolvedScene["camera"], aspect: number): PerspectiveCamera {
  const camera = new PerspectiveCamera(source.verticalFov, aspect, 1e-3, 1e7);
  camera.position.set(...source.position);
  camera.up.set(...source.up);
  camera.lookAt(...source.target);
  return camera;
}

/** Both for the camera and for light; black where there is none, since an image without a background has an alpha. */
function setEnvironment(world: Scene, radiance: Rgb): void {
  const isBlack = radiance.every((component) => component === 0);
  const rows = isBlack ? 1 : ENVIRONMENT_ROWS;
  const texels = new Float32Array(2 * rows * rows * 4);
  for (let i = 0; i < texels.length; i += 4) texels.set([...radiance, 1], i);
  const texture = new DataTexture(texels, 2 * rows, rows, RGBAFormat, FloatType, EquirectangularReflectionMapping);
  texture.needsUpdate = true;
  world.background = texture;
  if (!isBlack) world.environment = texture;
}

function convertObject(object: ResolvedObject, source: ResolvedMaterial, material: Material): (Mesh | Light)[] {
  const geometry = createGeometry(object);
  if (source.emission.every((component) => component === 0)) return [new Mesh(geometry, material)];
  switch (object.type) {
    case "quad": {
      const light = createAreaLight(object, source.emission);
      const back = light
        .getWorldDirection(new Vector3())
        .multiplyScalar(QUAD_SETBACK * Math.min(light.width, light.height));
      return [light, new Mesh(geometry.translate(...back.toArray()), material)];
    }
    case "sphere":
    case "box": {
      // Emission from the back, which a mesh has too, stays inside.
      const emitter = material.clone() as ReturnType<typeof createMaterial>;
      emitter.emissive = toColor(source.emission);
      return [new Mesh(geometry, emitter)];
    }
    default:
      throw unsupported(`emission from a quad, sphere or box, got a ${object.type}: it would shine from both sides`);
  }
}

/** A rectangle that shines along its -z, into edge1 × edge2. */
function createAreaLight(quad: ResolvedObject & { type: "quad" }, radiance: Rgb): RectAreaLight {
  const [edge1, edge2] = [new Vector3(...quad.edge1), new Vector3(...quad.edge2)];
  const [width, height] = [edge1.length(), edge2.length()];
  if (Math.abs(edge1.dot(edge2)) > 1e-6 * width * height) throw unsupported("edges of an emitter at right angles");
  const light = new RectAreaLight(toColor(radiance), 1, width, height);
  const z = edge1.clone().cross(edge2).normalize().negate();
  const x = edge1.clone().normalize();
  light.quaternion.setFromRotationMatrix(new Matrix4().makeBasis(x, z.clone().cross(x), z));
  light.position
    .set(...quad.corner)
    .addScaledVector(edge1, 0.5)
    .addScaledVector(edge2, 0.5);
  return light;
}

function convertLight(light: ResolvedLight): Mesh | Light {
  switch (light.type) {
    case "point": {
      // Its intensity is in W/sr.
      const point = new PointLight(toColor(scaled(light.power, 1 / (4 * Math.PI))), 1);
      point.position.set(...light.position);
      return point;
    }
    case "sphere": {
      const radiance = scaled(light.power, 1 / (4 * Math.PI ** 2 * light.radius ** 2));
      return new Mesh(createSphere(light.position, light.radius), createEmitter(radiance));
    }
    case "directional":
    case "spot":
      throw unsupported("lights with a direction");
  }
}

function scaled([r, g, b]: Rgb, factor: number): Rgb {
  return [r * factor, g * factor, b * factor];
}

function unsupported(expected: string): Error {
  return new Error(`three-gpu-pathtracer: expected ${expected}`);
}
