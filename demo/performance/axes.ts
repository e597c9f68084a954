/** From a value to a place in pixels, both ends included; logarithmic. */
export type Scale = (value: number) => number;

export type Range = readonly [from: number, to: number];

export function logScale([low, high]: Range, [start, end]: Range): Scale {
  const decades = Math.log(high / low);
  return (value) => start + ((end - start) * Math.log(value / low)) / decades;
}

const ROUND = [1, 2, 5];

/** The greatest of 1, 2, 5, 10, 20, … and their inverses that is at most `value`. */
export function roundDown(value: number): number {
  const decade = 10 ** Math.floor(Math.log10(value) + 1e-9);
  return decade * ROUND.findLast((round) => round * decade <= value * (1 + 1e-9))!;
}

/** The least of 1, 2, 5, 10, 20, … and their inverses that is at least `value`. */
export function roundUp(value: number): number {
  return 1 / roundDown(1 / value);
}

/** Where to draw a line: powers of ten, and in a short range what else is round. */
export function ticks([low, high]: Range): readonly number[] {
  const isShort = high / low < 50;
  const found: number[] = [];
  for (let exponent = Math.floor(Math.log10(low)); exponent <= Math.ceil(Math.log10(high)); exponent++) {
    // A division is right to the last digit where a negative power is not.
    const at = (round: number) => (exponent < 0 ? round / 10 ** -exponent : round * 10 ** exponent);
    for (const round of isShort ? ROUND : [1]) found.push(at(round));
  }
  return found.filter((value) => value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9));
}
