// Log-log plots as SVG that follows the reader's light or dark theme.

export type Point = { readonly x: number; readonly y: number };

export type Series = {
  /** In the legend. */
  readonly name: string;
  /** Beside its last point; the name by default. */
  readonly label?: string;
  /** In the legend, below the name. */
  readonly detail?: string;
  readonly points: readonly Point[];
};

export type Axis = { readonly title: string; readonly format: (value: number) => string };

export type Plot = {
  readonly title: string;
  /** Lines below the title, two at most. */
  readonly notes: readonly string[];
  readonly x: Axis;
  readonly y: Axis;
  /** Six at most, in the order of the legend. */
  readonly series: readonly Series[];
  /** Points to judge against y = x, with a band of ±10 %, on axes of one scale; else lines with their names. */
  readonly isAgreement?: boolean;
};

type Scale = { readonly at: (value: number) => number; readonly ticks: readonly Tick[] };
type Tick = { readonly value: number; readonly hasLabel: boolean };

const LEFT = 72;
const TOP = 84;
const LINE_HEIGHT = 18;
const LABEL_HEIGHT = 16;

const STYLE = `
    svg { --paper: #ffffff; --ink: #1f2328; --soft: #59636e; --grid: #d1d9e0; --fine: #eceff2;
      --c0: #0b62d6; --c1: #c2410c; --c2: #0f7b4f; --c3: #8b3fc7; --c4: #a16207; --c5: #be185d; }
    @media (prefers-color-scheme: dark) { svg { --paper: #0d1117; --ink: #e6edf3; --soft: #9198a1; --grid: #30363d; --fine: #1b2027;
      --c0: #58a6ff; --c1: #ff9350; --c2: #3fc77f; --c3: #c99aff; --c4: #e3b341; --c5: #ff7eb6; } }
    text { font: 12px system-ui, "Segoe UI", Helvetica, Arial, sans-serif; fill: var(--soft); }
    .title { font-size: 16px; font-weight: 600; fill: var(--ink); }
    .name { fill: var(--ink); }
    .label { font-weight: 600; } .joint { fill: none; stroke-opacity: 0.6; stroke-dasharray: 1.5 2.5; }
    .grid { stroke: var(--grid); } .fine { stroke: var(--fine); } .frame { fill: none; stroke: var(--grid); }
    .band { fill: var(--soft); fill-opacity: 0.16; } .diagonal { stroke: var(--soft); stroke-dasharray: 4 4; }
    .marker { stroke: var(--paper); stroke-width: 1; }
    polyline { fill: none; stroke-width: 2; stroke-linejoin: round; }`;

/** Draws a plot. There must be a point, and all coordinates positive. */
export function drawPlot({ title, notes, x, y, series, isAgreement = false }: Plot): string {
  const width = isAgreement ? 580 : 760;
  const right = width - (isAgreement ? 48 : 168);
  const bottom = TOP + (isAgreement ? right - LEFT : 330);
  const entryHeight = LINE_HEIGHT * (series.some(({ detail }) => detail !== undefined) ? 2 : 1);
  const height = bottom + 60 + entryHeight * series.length;
  const points = series.flatMap((one) => one.points);
  const [xs, ys] = [points.map((point) => point.x), points.map((point) => point.y)];
  const both = [...xs, ...ys];
  const scaleX = logScale(isAgreement ? both : xs, LEFT, right);
  const scaleY = logScale(isAgreement ? both : ys, bottom, TOP);
  const place = (point: Point): Point => ({ x: scaleX.at(point.x), y: scaleY.at(point.y) });

  const grid = [
    ...scaleX.ticks.map(({ value, hasLabel }) => {
      const at = round(scaleX.at(value));
      const label = hasLabel ? text(at, bottom + 18, x.format(value), `text-anchor="middle"`) : "";
      return `<path class="${hasLabel ? "grid" : "fine"}" d="M${at} ${TOP}V${bottom}"/>${label}`;
    }),
    ...scaleY.ticks.map(({ value, hasLabel }) => {
      const at = round(scaleY.at(value));
      const label = hasLabel ? text(LEFT - 8, at + 4, y.format(value), `text-anchor="end"`) : "";
      return `<path class="${hasLabel ? "grid" : "fine"}" d="M${LEFT} ${at}H${right}"/>${label}`;
    }),
  ];
  const middle = (TOP + bottom) / 2;
  const axes = [
    `<rect class="frame" x="${LEFT}" y="${TOP}" width="${right - LEFT}" height="${bottom - TOP}"/>`,
    text((LEFT + right) / 2, bottom + 38, x.title, `text-anchor="middle"`),
    text(18, middle, y.title, `text-anchor="middle" transform="rotate(-90 18 ${middle})"`),
  ];
  const lines = series.map(({ points }, i) => {
    const placed = points.map(place);
    const path = placed.map((point) => `${round(point.x)},${round(point.y)}`).join(" ");
    const line = isAgreement ? "" : `<polyline stroke="var(--c${i})" points="${path}"/>`;
    return line + placed.map((point) => marker(point, i)).join("");
  });
  const legend = series.flatMap(({ name, detail = "" }, i) => {
    const at = bottom + 66 + entryHeight * i;
    return [
      marker({ x: LEFT + 6, y: at - 4 }, i),
      text(LEFT + 20, at, name, `class="name"`),
      text(LEFT + 20, at + 15, detail),
    ];
  });
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" role="img">`,
    `<title>${escapeXml(title)}</title><style>${STYLE}\n  </style>`,
    `<rect width="100%" height="100%" fill="var(--paper)"/>`,
    text(LEFT, 26, title, `class="title"`),
    ...notes.map((note, i) => text(LEFT, 46 + LINE_HEIGHT * i, note)),
    ...grid,
    ...(isAgreement ? diagonal(scaleX, scaleY, both) : []),
    ...axes,
    ...lines,
    ...(isAgreement ? [] : endLabels(series, place, right, bottom)),
    ...legend,
    "</svg>\n",
  ].join("\n");
}

/** Covers the values with a little room; a line for each 1–9 of a decade, labels at decades, and at 2 and 5 if those are few. */
function logScale(values: readonly number[], from: number, to: number): Scale {
  const least = Math.log10(Math.min(...values));
  const most = Math.log10(Math.max(...values));
  const room = Math.max(0.06 * (most - least), 0.08);
  const [low, high] = [least - room, most + room];
  const labelled = high - low < 2 ? [1, 2, 5] : [1];
  const ticks: Tick[] = [];
  for (let decade = Math.floor(low); decade <= high; decade++) {
    for (let digit = 1; digit <= 9; digit++) {
      const value = Number(`${digit}e${decade}`);
      if (Math.log10(value) < low || Math.log10(value) > high) continue;
      ticks.push({ value, hasLabel: labelled.includes(digit) });
    }
  }
  return { at: (value) => from + ((Math.log10(value) - low) / (high - low)) * (to - from), ticks };
}

/** y = x and y = 0.9x to 1.1x, cut off where the data's frame would be left. */
function diagonal(scaleX: Scale, scaleY: Scale, values: readonly number[]): string[] {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const corner = (x: number, y: number) => `${round(scaleX.at(x))},${round(scaleY.at(y))}`;
  const band = [
    [low, 0.9 * low],
    [low, 1.1 * low],
    [high, 1.1 * high],
    [high, 0.9 * high],
  ] as const;
  const ends = [corner(low, low), corner(high, high)];
  return [
    `<polygon class="band" points="${band.map(([x, y]) => corner(x, y)).join(" ")}"/>`,
    `<path class="diagonal" d="M${ends.join("L")}"/>`,
  ];
}

/** Names to the right of the frame, each as near to the end of its line as the others leave room, and joined to it. */
function endLabels(series: readonly Series[], place: (point: Point) => Point, right: number, bottom: number): string[] {
  const ends = series
    .map(({ name, label = name, points }, i) => ({ label, i, ...place(points.at(-1)!) }))
    .sort((a, b) => a.y - b.y);
  const heights = spread(
    ends.map(({ y }) => y),
    LABEL_HEIGHT,
    bottom,
  );
  return ends.flatMap(({ label, i, x, y }, k) => {
    const at = round(heights[k]!);
    const joint = `M${round(x + 7)} ${round(y)}L${right} ${at}h8`;
    return [
      `<path class="joint" stroke="var(--c${i})" d="${joint}"/>`,
      text(right + 11, at + 4, label, `class="label" style="fill: var(--c${i})"`),
    ];
  });
}

/** Moves ascending places apart until neighbours are `distance` apart or more, and none is beyond `most`. */
export function spread(places: readonly number[], distance: number, most: number): number[] {
  const moved: number[] = [];
  for (const place of places) moved.push(Math.max(place, (moved.at(-1) ?? Number.NEGATIVE_INFINITY) + distance));
  let limit = most;
  for (let i = moved.length - 1; i >= 0; i--) {
    moved[i] = Math.min(moved[i]!, limit);
    limit = moved[i]! - distance;
  }
  return moved;
}

// Shapes as well as colours, within ±5 of the origin.
const SHAPES = [
  `<circle r="4.5"/>`,
  `<path d="M-4.5-4.5h9v9h-9z"/>`,
  `<path d="M0-5.5L5.2 4H-5.2z"/>`,
  `<path d="M0-6L6 0L0 6L-6 0z"/>`,
  `<path d="M0 5.5L5.2-4H-5.2z"/>`,
  `<path d="M-5-2h3v-3h4v3h3v4h-3v3h-4v-3h-3z"/>`,
];

function marker({ x, y }: Point, i: number): string {
  return `<g class="marker" fill="var(--c${i})" transform="translate(${round(x)} ${round(y)})">${SHAPES[i]}</g>`;
}

function text(x: number, y: number, words: string, attributes = ""): string {
  return `<text x="${round(x)}" y="${round(y)}" ${attributes}>${escapeXml(words)}</text>`;
}

function escapeXml(words: string): string {
  return words.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
}

function round(value: number): number {
  return Math.round(10 * value) / 10;
}
