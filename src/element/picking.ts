import type { PathTracer } from "../renderer/pathTracer";
import type { Picked } from "../renderer/picker";
import { watchClicks } from "./clicks";

/** Who wants to know what is picked. */
export type PickingTarget = {
  /** What shows the picture; `undefined` while nothing is to be picked. */
  readonly tracer: () => PathTracer | undefined;
  /** Called with what was clicked; `undefined` is nothing, and Escape. */
  readonly onPick: (picked: Picked | undefined) => void;
  readonly onError: (error: Error) => void;
};

/**
 * Lets a click on a picture pick what is seen there, and Escape let go of it.
 *
 * @param host - has the keyboard.
 * @param signal - ends it.
 */
export function bindPicking(host: HTMLElement, canvas: HTMLElement, target: PickingTarget, signal: AbortSignal): void {
  const pick = async (x: number, y: number): Promise<void> => {
    const tracer = target.tracer();
    if (tracer === undefined) return;
    const { scene } = tracer;
    try {
      const picked = await tracer.pick(x * tracer.width, y * tracer.height);
      if (target.tracer()?.scene === scene) target.onPick(picked);
    } catch (error) {
      if (target.tracer() === tracer) target.onError(error as Error); // a lost device is replaced, and told of as such
    }
  };
  watchClicks(canvas, ({ x, y }) => void pick(x, y), signal);
  host.addEventListener("keydown", ({ key }) => void (key === "Escape" && target.onPick(undefined)), { signal });
}
