// Sample points, addressed by (pixel, sample, dimension): one two-dimensional point per address.
//
// Every address of a pixel is its own Owen-scrambled two-dimensional Sobol sequence over the sample index, with the
// index shuffled by address so that points of different dimensions are independent.
//
// [1] Burley 2020, "Practical Hash-based Owen Scrambling", JCGT 9(4)
// [2] Ahmed 2024, "An Implementation Algorithm of 2D Sobol Sequence Fast, Elegant, and Compact", EGSR
// [3] Vegdahl 2021, "Building a Better LK Hash", psychopath.io/post/2021_01_30_building_a_better_lk_hash
// [4] Jarzynski, Olano 2020, "Hash Functions for GPU Rendering", JCGT 9(3)

struct Sampler {
  // Of the pixel, the film half and the user's seed.
  seed: u32,
  // Sample index; bit-reversed for Sobol points.
  index: u32,
}

fn makeSampler(pixel: vec2u, half: u32, seed: u32, index: u32) -> Sampler {
  let hash = pcg3d(vec3u(pixel.x | (half << 31u), pixel.y, seed)).x;
  @if(SOBOL) return Sampler(hash, reverseBits(index));
  @if(!SOBOL) return Sampler(hash, index);
}

// A point in [0, 1)².
@if(SOBOL)
fn point(samples: Sampler, dimension: u32) -> vec2f {
  let seeds = pcg3d(vec3u(samples.seed, dimension, 0x9e3779b9u));
  // Nested uniform shuffle of the index: an Owen scramble of the index read as a binary fraction. [1] section 2.3
  let reversed = scrambleReversed(samples.index, seeds.z);
  return vec2f(
    unitInterval(reverseBits(scrambleReversed(reverseBits(reversed), seeds.x))),
    unitInterval(reverseBits(scrambleReversed(reverseBits(sobol(reversed)), seeds.y))),
  );
}

@if(!SOBOL)
fn point(samples: Sampler, dimension: u32) -> vec2f {
  let bits = pcg3d(vec3u(samples.seed, dimension, samples.index));
  return vec2f(unitInterval(bits.x), unitInterval(bits.y));
}

// A pseudo-random number in [0, 1), a third as costly as a point, for decisions that gain nothing from good points.
fn independent(samples: Sampler, dimension: u32) -> f32 {
  return unitInterval(pcg3d(vec3u(samples.seed, dimension | 0x40000000u, samples.index)).x);
}

// Sampler for the i-th of `count` points that one sample takes in the same dimension.
fn subsample(samples: Sampler, i: u32, count: u32) -> Sampler {
  @if(SOBOL) return Sampler(samples.seed, reverseBits(reverseBits(samples.index) * count + i));
  @if(!SOBOL) return Sampler(samples.seed, samples.index * count + i);
}

// The second Sobol dimension of a bit-reversed index: multiplication by Pascal's triangle mod 2, in five steps. [2]
// Products for shifts to the left: an adapter without vector shifts is quicker with them, and others shift.
fn sobol(reversed: u32) -> u32 {
  var x = reversed;
  x ^= (x & 0x55555555u) * 0x2u;
  x ^= (x & 0x33333333u) * 0x4u;
  x ^= (x & 0x0f0f0f0fu) * 0x10u;
  x ^= (x & 0x00ff00ffu) * 0x100u;
  x ^= x * 0x10000u;
  return x;
}

// Owen scrambling of a bit-reversed value: every bit is flipped by a hash of the bits below it. [3]
fn scrambleReversed(value: u32, seed: u32) -> u32 {
  var x = value;
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16u) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

// The largest result is 1 − 2⁻²⁴.
fn unitInterval(bits: u32) -> f32 {
  return f32(bits & 0xffffff00u) * 0x1p-32;
}

// [4] listing 4
fn pcg3d(value: vec3u) -> vec3u {
  var v = value * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> vec3u(16u);
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return v;
}
