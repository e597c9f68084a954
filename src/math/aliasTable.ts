/**
 * Choices in proportion to weights, in constant time: with probability `probability[i]` a uniformly chosen entry i stands,
 * otherwise `alias[i]` takes its place (Walker 1977, "An Efficient Method for Generating Discrete Random Variables with
 * General Distributions"; construction by Vose 1991).
 *
 * @param weights - not negative, and not all zero.
 */
export function aliasTable(weights: Float64Array): { probability: Float64Array; alias: Uint32Array } {
  const count = weights.length;
  const total = weights.reduce((sum, weight) => sum + weight, 0);
  // Shares of an entry's own, in units of an even share.
  const probability = weights.map((weight) => (weight / total) * count);
  const alias = Uint32Array.from(weights, (_, i) => i);
  const small: number[] = [];
  const large: number[] = [];
  for (let i = 0; i < count; i++) (probability[i]! < 1 ? small : large).push(i);
  while (small.length > 0 && large.length > 0) {
    const [poor, rich] = [small.pop()!, large.pop()!];
    alias[poor] = rich;
    probability[rich]! -= 1 - probability[poor]!;
    (probability[rich]! < 1 ? small : large).push(rich);
  }
  // What is left differs from an even share by rounding only.
  for (const i of [...small, ...large]) probability[i] = 1;
  return { probability, alias };
}
