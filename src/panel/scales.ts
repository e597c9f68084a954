// How far dragging and arrow keys change a number, and how it is written.

// Of a value without bounds: what a pixel of dragging and an arrow key add, as a share of it.
const DRAG_SHARE = 0.01;
const KEY_SHARE = 0.05;

export function scalesFor(value: number) {
  const size = value > 0 ? value : 1;
  return { pointerScale: DRAG_SHARE * size, keyScale: KEY_SHARE * size, format: formatShort };
}

/** To thousandths. Tweakpane's own steps are counted from the first value, and miss 0 and 1 by a rounding error. */
export function rounded(value: number): number {
  return Math.round(1000 * value) / 1000;
}

/** Four digits: as many as fit. */
function formatShort(value: number): string {
  return String(Number(value.toPrecision(4)));
}
