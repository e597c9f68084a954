import type { Vec3 } from "../../src/scene/schema";

/** Numbers in [0, 1) from a seed: mulberry32. */
export function createRandom(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** A unit vector, all directions alike. */
export function randomDirection(random: () => number): Vec3 {
  const z = 2 * random() - 1;
  const phi = 2 * Math.PI * random();
  const r = Math.sqrt(1 - z * z);
  return [r * Math.cos(phi), r * Math.sin(phi), z];
}

/** A local direction in which a ray goes on: cosine-distributed around z, a tenth of them grazing, at down to 10⁻⁷. */
export function scatteredDirection(random: () => number): Vec3 {
  const z = random() < 0.1 ? 10 ** (-1 - 6 * random()) : Math.sqrt(random());
  const phi = 2 * Math.PI * random();
  const r = Math.sqrt(1 - z * z);
  return [r * Math.cos(phi), r * Math.sin(phi), z];
}
