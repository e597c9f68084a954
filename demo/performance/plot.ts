import { logScale, type Range, roundDown, roundUp, type Scale, ticks } from "./axes";
import { percent, times } from "./format";
import { isKnown, type Lead, lastKnown, type Point } from "./statistics";

export type Curve = {
  /** Class of what belongs to it; its colour. */
  readonly key: string;
  readonly label: string;
  /** Where there is little room. */
  readonly shortLabel: string;
  readonly points: readonly Point[];
};

export type PlotModel = {
  readonly curves: readonly Curve[];
  /** The reference's relative RMSE. */
  readonly ownError: number;
  /** Seconds at which the race ends. */
  readonly limit: number;
  /** Drawn as the distance between the curves. */
  readonly lead: Lead | undefined;
};

// What the axes show before there is anything to show, and the least that the upper one spans.
const FIRST_SECOND = 0.005;
const ERRORS: Range = [0.02, 1];
const LEAST_SPAN = 30;

// Pixels. Under a short distance between the curves, a long label would lie on one of them.
const NARROW = 520;
const LABEL_HEIGHT = 36;
const SHORT_LEAD = 150;
const LEAST_LEAD = 48;

type Frame = { readonly left: number; readonly right: number; readonly top: number; readonly bottom: number };
type Axes = {
  readonly x: Scale;
  readonly y: Scale;
  readonly times: Range;
  readonly errors: Range;
  readonly frame: Frame;
  readonly isNarrow: boolean;
};

/** A log-log plot of error against time, as sharp as the screen and as wide as its place. */
export class Plot {
  readonly #svg: SVGSVGElement;
  #model: PlotModel | undefined;

  constructor(svg: SVGSVGElement) {
    this.#svg = svg;
    new ResizeObserver(() => this.#draw()).observe(svg);
  }

  show(model: PlotModel): void {
    this.#model = model;
    this.#draw();
  }

  #draw(): void {
    const { clientWidth: width, clientHeight: height } = this.#svg;
    if (!this.#model || width === 0 || height === 0) return;
    this.#svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.#svg.innerHTML = drawing(this.#model, width, height);
    this.#svg.setAttribute("aria-label", inWords(this.#model));
  }
}

/** The plot's inside as SVG. Only numbers and our own labels enter it. */
function drawing(model: PlotModel, width: number, height: number): string {
  const axes = axesFor(model, width, height);
  return [
    noiseBand(model.ownError, axes),
    grid(axes),
    ...model.curves.map((curve) => lines(curve, axes)),
    model.lead ? distance(model.lead, axes) : "",
    endLabels(model, axes),
  ].join("");
}

function axesFor({ curves, limit }: PlotModel, width: number, height: number): Axes {
  const isNarrow = width < NARROW;
  const frame = { left: isNarrow ? 50 : 60, right: width - (isNarrow ? 74 : 130), top: 34, bottom: height - 46 };
  const points = curves.flatMap((curve) => curve.points);
  const seconds = points.map((point) => point.seconds);
  const known = points
    .flatMap((point) => [point.trueError, point.estimatedError])
    .filter((error) => error !== undefined);
  const times: Range = [
    seconds.length > 0 ? roundDown(Math.min(...seconds)) : FIRST_SECOND,
    Math.max(limit, ...seconds),
  ];
  const highest = known.length > 0 ? roundUp(Math.max(...known) * 1.05) : ERRORS[1];
  const lowest = known.length > 0 ? roundDown(Math.min(...known) / 1.3) : ERRORS[0];
  const errors: Range = [Math.min(lowest, roundDown(highest / LEAST_SPAN)), highest];
  return {
    x: logScale(times, [frame.left, frame.right]),
    y: logScale(errors, [frame.bottom, frame.top]),
    times,
    errors,
    frame,
    isNarrow,
  };
}

function grid({ x, y, times, errors, frame }: Axes): string {
  const { left, right, top, bottom } = frame;
  const vertical = ticks(times).map((seconds) => {
    const at = px(x(seconds));
    return `<path class="grid" d="M${at} ${top}V${bottom}"/><text class="tick" x="${at}" y="${bottom + 20}" text-anchor="middle">${secondsLabel(seconds)}</text>`;
  });
  const horizontal = ticks(errors).map((error) => {
    const at = px(y(error));
    return `<path class="grid" d="M${left} ${at}H${right}"/><text class="tick" x="${left - 9}" y="${at + 4}" text-anchor="end">${errorLabel(error)}</text>`;
  });
  return [
    ...vertical,
    ...horizontal,
    `<path class="axis" d="M${left} ${top}V${bottom}H${right}"/>`,
    `<text class="title" x="0" y="14">error of the picture</text>`,
    `<text class="title" x="${right}" y="${bottom + 40}" text-anchor="end">time, each on its own clock</text>`,
  ].join("");
}

function noiseBand(ownError: number, { y, errors, frame }: Axes): string {
  if (ownError <= errors[0] * 1.02) return "";
  const { left, right, bottom } = frame;
  const top = px(y(Math.min(ownError, errors[1])));
  const label =
    bottom - top > 20
      ? `<text class="note" x="${left + 10}" y="${bottom - 9}">noise of the reference itself</text>`
      : "";
  return `<rect class="noise" x="${left}" y="${top}" width="${right - left}" height="${px(bottom - top)}"/>${label}`;
}

function lines({ key, points }: Curve, { x, y }: Axes): string {
  const place = (point: Point, error: number) => `${px(x(point.seconds))} ${px(y(error))}`;
  const known = points.filter(isKnown);
  const truth = known.map((point) => place(point, point.trueError));
  const estimate = points.flatMap((point) => (point.estimatedError ? [place(point, point.estimatedError)] : []));
  const path = (kind: string, places: readonly string[]) =>
    places.length > 1 ? `<path class="${kind} ${key}" d="M${places.join("L")}"/>` : "";
  const dots = known.map((point, index) => {
    const radius = index === known.length - 1 ? 4.5 : 2.25;
    return `<circle class="${key}" cx="${px(x(point.seconds))}" cy="${px(y(point.trueError))}" r="${radius}"/>`;
  });
  return `${path("estimate", estimate)}${path("truth", truth)}${dots.join("")}`;
}

/** How far apart the curves are at the least error that the slower one has had. */
function distance({ error, sooner, later, factor, isAtLeast }: Lead, { x, y }: Axes): string {
  const [start, end, at] = [px(x(sooner)) + 7, px(x(later)) - 9, px(y(error))];
  if (end - start < LEAST_LEAD) return "";
  const heads = `M${start + 6} ${at - 4}L${start} ${at}L${start + 6} ${at + 4}M${end - 6} ${at - 4}L${end} ${at}L${end - 6} ${at + 4}`;
  const text = `${isAtLeast ? "≥ " : ""}${times(factor)}${end - start < SHORT_LEAD ? "" : " sooner"}`;
  return `<path class="lead" d="M${start} ${at}H${end}${heads}"/><text class="lead" x="${end - 4}" y="${at + 22}" text-anchor="end">${text}</text>`;
}

/** Name and error of each curve beside its end, moved apart where they would overlap. */
function endLabels({ curves, ownError }: PlotModel, { x, y, frame, isNarrow }: Axes): string {
  const labels = curves.flatMap(({ key, label, shortLabel, points }) => {
    const end = lastKnown(points);
    if (end === undefined) return [];
    const isBelow = points.at(-1)?.trueError === undefined;
    const value = isBelow ? `< ${percent(ownError)}` : percent(end.trueError);
    return [{ key, name: isNarrow ? shortLabel : label, value, x: x(end.seconds) + 11, y: y(end.trueError) }];
  });
  labels.sort((a, b) => a.y - b.y);
  const [upper, lower] = labels;
  if (upper && lower && lower.y - upper.y < LABEL_HEIGHT) {
    const middle = (upper.y + lower.y) / 2;
    upper.y = middle - LABEL_HEIGHT / 2;
    lower.y = middle + LABEL_HEIGHT / 2;
  }
  return labels
    .map(({ key, name, value, x: left, y: middle }) => {
      const base = px(Math.min(Math.max(middle, frame.top + 8), frame.bottom - 14));
      return `<text class="end ${key}" x="${px(left)}" y="${base - 2}">${name}<tspan class="value" x="${px(left)}" dy="16">${value}</tspan></text>`;
    })
    .join("");
}

function inWords({ curves, lead }: PlotModel): string {
  const ends = curves.flatMap(({ label, points }) => {
    const end = lastKnown(points);
    return end ? [`${label}: ${percent(end.trueError)} error after ${end.seconds.toPrecision(3)} seconds`] : [];
  });
  if (ends.length === 0) return "Error against time. No points yet.";
  return `Error against time. ${ends.join("; ")}.${lead ? ` The first is ${times(lead.factor)} sooner.` : ""}`;
}

function secondsLabel(seconds: number): string {
  return seconds < 1 ? `${Number((seconds * 1000).toPrecision(3))} ms` : `${seconds} s`;
}

function errorLabel(error: number): string {
  return `${Number((error * 100).toPrecision(3)).toLocaleString("en")} %`;
}

/** To a tenth of a pixel. */
function px(value: number): number {
  return Math.round(value * 10) / 10;
}
