import type { FolderApi } from "tweakpane";
import { addOwnBlade } from "./ownBlade";

/** What a coordinate runs over, and the values that are marked on it, each with what is written there. */
export type Axis = {
  readonly min: number;
  readonly max: number;
  readonly marks: readonly { readonly at: number; readonly text: string }[];
};

type Point = readonly [x: number, y: number];

export type Plot = {
  readonly x: Axis;
  readonly y: Axis;
  /** In the axes' coordinates. Points that are no numbers are left out. */
  readonly line: readonly Point[];
  /** A straight dashed line to compare with. */
  readonly guide?: readonly [Point, Point];
};

/** What is written at a point of the drawing, in units of it. */
type Text = { readonly text: string; readonly left: number; readonly top: number; readonly className: string };

const SVG = "http://www.w3.org/2000/svg";
// Of the drawing, in units of its own; it is stretched to its place.
const SIZE = 100;

/** A line over a grid, with a heading. */
export class Graph {
  readonly #value: HTMLElement;
  readonly #note: HTMLElement;
  readonly #grid: SVGElement;
  readonly #guide: SVGElement;
  readonly #line: SVGElement;
  readonly #plot: HTMLElement;
  #texts: HTMLElement[] = [];

  constructor(pane: FolderApi) {
    const blade = addOwnBlade(pane);
    const document = blade.ownerDocument;
    const create = (className: string) => {
      const element = document.createElement("div");
      element.className = className;
      return element;
    };
    const draw = (tag: string, className: string) => {
      const element = document.createElementNS(SVG, tag);
      element.setAttribute("class", className);
      element.setAttribute("vector-effect", "non-scaling-stroke");
      return element;
    };
    this.#value = create("graph-value");
    this.#note = create("graph-note");
    this.#plot = create("graph-plot");
    this.#grid = draw("path", "graph-grid");
    this.#guide = draw("path", "graph-guide");
    this.#line = draw("polyline", "graph-line");

    const svg = document.createElementNS(SVG, "svg");
    svg.setAttribute("viewBox", `0 0 ${SIZE} ${SIZE}`);
    svg.setAttribute("preserveAspectRatio", "none");
    svg.setAttribute("aria-hidden", "true"); // the heading says it in words
    svg.append(this.#grid, this.#guide, this.#line);
    this.#plot.append(svg);
    const head = create("graph-head");
    head.append(this.#value, this.#note);
    blade.className = `${blade.className} graph`;
    blade.append(head, this.#plot);
  }

  /** Sets what is written above the graph, on the left and on the right. */
  setHeading(value: string, note: string): void {
    setText(this.#value, value);
    setText(this.#note, note);
  }

  draw({ x, y, line, guide }: Plot): void {
    const across = (value: number) => round(shareOf(value, x) * SIZE);
    const down = (value: number) => round((1 - shareOf(value, y)) * SIZE);
    let points = "";
    for (const [px, py] of line) {
      if (Number.isFinite(px) && Number.isFinite(py)) points += `${across(px)},${down(py)} `;
    }
    setAttribute(this.#line, "points", points);
    const ruled = [
      ...x.marks.map(({ at }) => `M${across(at)} 0V${SIZE}`),
      ...y.marks.map(({ at }) => `M0 ${down(at)}H${SIZE}`),
    ];
    setAttribute(this.#grid, "d", ruled.join(""));
    setAttribute(this.#guide, "d", guide ? `M${guide.map(([px, py]) => `${across(px)} ${down(py)}`).join("L")}` : "");
    this.#write([
      ...x.marks.map(({ at, text }) => ({ text, left: across(at), top: SIZE, className: "below" })),
      ...y.marks.map(({ at, text }) => ({ text, left: 0, top: down(at), className: "" })),
    ]);
  }

  /** In HTML, because the drawing's own text would be stretched with it. Elements are used again. */
  #write(texts: readonly Text[]): void {
    while (this.#texts.length > texts.length) this.#texts.pop()?.remove();
    while (this.#texts.length < texts.length) {
      const element = this.#plot.ownerDocument.createElement("span");
      this.#plot.append(element);
      this.#texts.push(element);
    }
    for (const [i, { text, left, top, className }] of texts.entries()) {
      const element = this.#texts[i]!;
      setText(element, text);
      setAttribute(element, "class", className);
      const [x, y] = [`${left}%`, `${top}%`];
      if (element.style.left !== x) element.style.left = x;
      if (element.style.top !== y) element.style.top = y;
    }
  }
}

/** The powers of ten from `min` to `max`, both logarithms to base 10, as marks. */
export function decades(min: number, max: number, format: (value: number) => string): Axis["marks"] {
  const first = Math.ceil(min);
  const count = Math.max(0, Math.floor(max) - first + 1);
  return Array.from({ length: count }, (_, i) => ({ at: first + i, text: format(10 ** (first + i)) }));
}

function shareOf(value: number, { min, max }: Axis): number {
  return (value - min) / (max - min);
}

/** More digits than a screen shows only make long text. */
function round(value: number): number {
  return Math.round(100 * value) / 100;
}

// What is set again to the same would be laid out again.

function setAttribute(element: Element, name: string, value: string): void {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}

function setText(element: HTMLElement, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}
