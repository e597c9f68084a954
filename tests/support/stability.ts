/** `npm run test:long` tries ten times the inputs. */
export const LONG = process.env.RT_VIEWER_LONG ? 10 : 1;

/** A count with thousands marked: 1,000,000. */
export function count(value: number): string {
  return value.toLocaleString("en-US");
}

/** A small number in two digits: 1.3e-7. */
export function small(value: number): string {
  return value === 0 ? "0" : value.toExponential(1);
}
