import type { Texture } from "rt-viewer";

type Point = readonly [x: number, y: number];

// Strokes through a box of width 1 and height 1, from its lower left corner.
const LETTERS: { readonly [letter: string]: readonly Point[] } = {
  L: [
    [0.1, 1],
    [0.1, 0],
    [0.75, 0],
  ],
  U: [
    [0.05, 1],
    [0.05, 0.35],
    [0.12, 0.13],
    [0.28, 0.01],
    [0.5, 0],
    [0.68, 0.05],
    [0.83, 0.19],
    [0.88, 0.4],
    [0.88, 1],
  ],
  M: [
    [0, 0],
    [0.06, 1],
    [0.5, 0.15],
    [0.94, 1],
    [1, 0],
  ],
  E: [
    [0.8, 1],
    [0.12, 1],
    [0.12, 0.5],
    [0.7, 0.5],
    [0.12, 0.5],
    [0.12, 0],
    [0.8, 0],
  ],
  N: [
    [0.06, 0],
    [0.06, 1],
    [0.9, 0],
    [0.9, 1],
  ],
};
const [WIDTH, HEIGHT] = [552, 360];
const PAPER = [238, 232, 222];
const INK = [52, 38, 30];

/** A label with a word of these letters in the middle, and a line around it. */
export function printedWord(word: string): Texture {
  const [size, pitch] = [56, 82];
  const left = (WIDTH - pitch * (word.length - 1) - size) / 2;
  const strokes = [...word].flatMap((letter, place) => {
    const points = LETTERS[letter] ?? [];
    const across = points.map(([x, y]) => [left + pitch * place + size * x, HEIGHT / 2 + size * (0.5 - y)] as const);
    return across.slice(1).map((end, i) => [across[i]!, end] as const);
  });
  const texels = Array.from({ length: WIDTH * HEIGHT }, (_, i) => {
    const at: Point = [(i % WIDTH) + 0.5, Math.floor(i / WIDTH) + 0.5];
    const toEdge = Math.min(at[0], at[1], WIDTH - at[0], HEIGHT - at[1]);
    const toFrame = Math.abs(toEdge - 22) - 1.5;
    const isNear = Math.abs(at[1] - HEIGHT / 2) < size;
    const toWord = isNear ? Math.min(...strokes.map((stroke) => distance(at, stroke))) - 3 : HEIGHT;
    const ink = Math.min(Math.max(0.5 - Math.min(toFrame, toWord), 0), 1);
    return [...PAPER.map((paper, channel) => Math.round(paper + ink * (INK[channel]! - paper))), 255];
  });
  return { width: WIDTH, height: HEIGHT, texels: texels.flat(), wrapU: "clamp", wrapV: "clamp" };
}

function distance([x, y]: Point, [[x0, y0], [x1, y1]]: readonly [Point, Point]): number {
  const [dx, dy] = [x1 - x0, y1 - y0];
  const along = Math.min(Math.max(((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy), 0), 1);
  return Math.hypot(x - x0 - along * dx, y - y0 - along * dy);
}
