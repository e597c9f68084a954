// The sampler of wgsl/sampler.wgsl in integers, written from the papers: what its points must be, bit for bit.
//
// [1] Sobol' 1967; Joe, Kuo 2008, "Constructing Sobol sequences with better two-dimensional projections": direction numbers
// [2] Burley 2020, "Practical Hash-based Owen Scrambling", JCGT 9(4)
// [3] Vegdahl 2021, "Building a Better LK Hash"
// [4] Jarzynski, Olano 2020, "Hash Functions for GPU Rendering", JCGT 9(3): pcg3d

/** Which point: everything that `makeSampler` and `point` are told. */
export type Address = {
  readonly x: number;
  readonly y: number;
  readonly half: 0 | 1;
  readonly seed: number;
  readonly dimension: number;
};

/** The sequence of an address, as the numerators of 24-bit fractions: `(index) => [x, y]`. */
export function sobolSequence({ x, y, half, seed, dimension }: Address): (index: number) => [number, number] {
  const [own] = pcg3d(half === 1 ? (x | 0x80000000) >>> 0 : x, y, seed);
  const [seedX, seedY, shuffle] = pcg3d(own, dimension, 0x9e3779b9);
  return (index) => {
    const shuffled = owenScramble(index, shuffle);
    return [
      owenScramble(sobol(shuffled, VAN_DER_CORPUT), seedX) >>> 8,
      owenScramble(sobol(shuffled, SECOND), seedY) >>> 8,
    ];
  };
}

/** The i-th sample's number in a light-sampling sequence of `count` points per sample. */
export function subsampleIndex(index: number, i: number, count: number): number {
  return (Math.imul(index, count) + i) >>> 0;
}

// Direction numbers of the first two Sobol' dimensions: v_k = 2^(31−k), and v_k = v_(k−1) xor v_(k−1)/2. [1]
const VAN_DER_CORPUT = directions((previous) => previous >>> 1);
const SECOND = directions((previous) => (previous ^ (previous >>> 1)) >>> 0);

function directions(next: (previous: number) => number): number[] {
  const numbers = [0x80000000];
  while (numbers.length < 32) numbers.push(next(numbers.at(-1)!));
  return numbers;
}

/** The xor of the direction numbers of the index's bits, binary order. [1] */
function sobol(index: number, numbers: readonly number[]): number {
  let point = 0;
  for (let bit = 0; bit < 32; bit++) if ((index >>> bit) & 1) point ^= numbers[bit]!;
  return point >>> 0;
}

/** Owen scrambling by a Laine–Karras-style permutation of the reversed bits, with Vegdahl's constants. [2, 3] */
function owenScramble(value: number, seed: number): number {
  let v = reverseBits(value);
  v = (v ^ Math.imul(v, 0x3d20adea)) >>> 0;
  v = (v + seed) >>> 0;
  v = Math.imul(v, (seed >>> 16) | 1) >>> 0;
  v = (v ^ Math.imul(v, 0x05526c56)) >>> 0;
  v = (v ^ Math.imul(v, 0x53a22864)) >>> 0;
  return reverseBits(v);
}

function reverseBits(value: number): number {
  let reversed = 0;
  for (let bit = 0; bit < 32; bit++) reversed = ((reversed << 1) | ((value >>> bit) & 1)) >>> 0;
  return reversed;
}

/** [4] */
function pcg3d(x: number, y: number, z: number): [number, number, number] {
  const step = (value: number) => (Math.imul(value, 1664525) + 1013904223) >>> 0;
  let [a, b, c] = [step(x), step(y), step(z)];
  const mix = () => {
    a = (a + Math.imul(b, c)) >>> 0;
    b = (b + Math.imul(c, a)) >>> 0;
    c = (c + Math.imul(a, b)) >>> 0;
  };
  mix();
  [a, b, c] = [(a ^ (a >>> 16)) >>> 0, (b ^ (b >>> 16)) >>> 0, (c ^ (c >>> 16)) >>> 0];
  mix();
  return [a, b, c];
}
