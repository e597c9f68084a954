import type { RtViewerElement } from "rt-viewer/element";

/** Every picture in sight gets this many samples before one of them has the machine to itself. */
const FAIR_SAMPLES = 16;

/** Lets one viewer compute at a time: the one pointed at or focused, else the least finished, else the most visible. */
export function takeTurns(viewers: readonly RtViewerElement[]): void {
  const visible = new Map<RtViewerElement, number>();

  const choose = () => {
    const chosen = nextViewer(viewers, visible);
    for (const viewer of viewers) viewer.paused = viewer !== chosen;
  };
  const observer = new IntersectionObserver(
    (entries) => {
      for (const { target, intersectionRatio } of entries) visible.set(target as RtViewerElement, intersectionRatio);
      choose();
    },
    { threshold: [0, 0.25, 0.5, 0.75, 1] },
  );
  for (const viewer of viewers) {
    observer.observe(viewer);
    for (const type of ["progress", "ready", "pointerenter", "pointerleave", "focusin", "focusout"]) {
      viewer.addEventListener(type, choose);
    }
  }
}

function nextViewer(
  viewers: readonly RtViewerElement[],
  visible: ReadonlyMap<RtViewerElement, number>,
): RtViewerElement | undefined {
  const inSight = viewers.filter((viewer) => (visible.get(viewer) ?? 0) > 0 && viewer.stats !== undefined);
  const wanted = inSight.find((viewer) => viewer.matches(":hover, :focus-within"));
  if (wanted !== undefined) return wanted;
  const samplesOf = (viewer: RtViewerElement) => viewer.stats?.samples ?? 0;
  const unfinished = inSight.filter((viewer) => samplesOf(viewer) < FAIR_SAMPLES);
  if (unfinished.length > 0) return unfinished.reduce((a, b) => (samplesOf(b) < samplesOf(a) ? b : a));
  return inSight.reduce<RtViewerElement | undefined>(
    (a, b) => (a === undefined || (visible.get(b) ?? 0) > (visible.get(a) ?? 0) ? b : a),
    undefined,
  );
}
