import type { ShaderMaterial } from "three";
import type { WebGLPathTracer } from "three-gpu-pathtracer";

// What the path tracer has no option for, and without which it renders another picture than the format asks for. Each
// change is in its favour: against the same reference, the differences would count as its error.
const CHANGES: readonly (readonly [from: string, to: string])[] = [
  // A box over the pixel in place of a tent over four.
  [
    "vUv + vec2( tentFilter( ruv.x ) * ssd.x, tentFilter( ruv.y ) * ssd.y )",
    "vUv + vec2( ruv.x - 0.5, ruv.y - 0.5 ) * ssd",
  ],
  // The camera sees area lights, as its own TODO suggests: a mesh in their place would emit a second time.
  ["if ( ! state.firstRay && ! state.transmissiveRay ) {", "if ( state.firstRay || ! state.transmissiveRay ) {"],
  [
    "float misWeight = misHeuristic( scatterRec.pdf, lightRec.pdf / lightsDenom );",
    "float misWeight = state.firstRay ? 1.0 : misHeuristic( scatterRec.pdf, lightRec.pdf / lightsDenom );",
  ],
  // Light samples are left out where the path ends anyway: they would scatter once more than what the path itself finds.
  [
    "gl_FragColor.rgb += directLightContribution( - ray.direction, surf, state, hitPoint );",
    "if ( i < bounces - 1 ) gl_FragColor.rgb += directLightContribution( - ray.direction, surf, state, hitPoint );",
  ],
];

/**
 * Gives a path tracer the pixel filter, the visible lights and the path length of our format. Call before its first sample.
 *
 * @throws {Error} if its shader is not that of version 0.0.26.
 */
export function patchShader(tracer: WebGLPathTracer): void {
  const { material } = (tracer as unknown as { _pathTracer: { material: ShaderMaterial } })._pathTracer;
  for (const [from, to] of CHANGES) {
    const parts = material.fragmentShader.split(from);
    if (parts.length !== 2) {
      throw new Error(`three-gpu-pathtracer: expected "${from}" once in its shader, found ${parts.length - 1}`);
    }
    material.fragmentShader = parts.join(to);
  }
  material.needsUpdate = true;
}
