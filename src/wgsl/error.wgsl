// Sums, over the film, what the error estimate needs: the squared difference of the half means and the image itself.

struct ErrorUniforms {
  pixelCount: u32,
}

@group(0) @binding(0) var<uniform> params: ErrorUniforms;
// Radiance sums and sample counts, half 0 then half 1.
@group(0) @binding(1) var<storage, read> film: array<vec4f>;
// Per workgroup: x squared error of the image, summed over channels; y radiance, summed over channels; z pixels that hold
// samples in both halves. Read by the renderer.
@group(0) @binding(2) var<storage, read_write> partialSums: array<vec4f>;

const WORKGROUP_SIZE = 64u;

var<workgroup> sums: array<vec4f, WORKGROUP_SIZE>;

@compute @workgroup_size(WORKGROUP_SIZE)
fn sumErrors(
  @builtin(local_invocation_index) lane: u32,
  @builtin(workgroup_id) group: vec3u,
  @builtin(num_workgroups) groups: vec3u,
) {
  var sum = vec4f(0.0);
  for (var pixel = group.x * WORKGROUP_SIZE + lane; pixel < params.pixelCount; pixel += groups.x * WORKGROUP_SIZE) {
    sum += pixelError(film[pixel], film[params.pixelCount + pixel]);
  }
  sums[lane] = sum;
  for (var stride = WORKGROUP_SIZE / 2u; stride > 0u; stride /= 2u) {
    workgroupBarrier();
    if (lane < stride) { sums[lane] += sums[lane + stride]; }
  }
  if (lane == 0u) { partialSums[group.x] = sums[0]; }
}

// With a and b the half means of n_a and n_b samples, (a − b)²·n_a·n_b/(n_a + n_b)² has the variance of the image's pixel
// as its expectation; for equal halves it is (a − b)²/4.
fn pixelError(a: vec4f, b: vec4f) -> vec4f {
  if (a.w == 0.0 || b.w == 0.0) { return vec4f(0.0); }
  let difference = a.rgb / a.w - b.rgb / b.w;
  let mean = (a.rgb + b.rgb) / (a.w + b.w);
  let share = a.w / (a.w + b.w);
  return vec4f(dot(difference, difference) * share * (1.0 - share), dot(mean, vec3f(1.0)), 1.0, 0.0);
}
