import type { ScenePart } from "../compile/primitives";
import type { PathTracer } from "../renderer/pathTracer";
import type { Picked } from "../renderer/picker";
import type { ResolvedScene } from "../scene/schema";
import { watchClicks } from "./clicks";
import type { PickDetail } from "./events";

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
    const picked = await tracer.pick(x * tracer.width, y * tracer.height);
    if (target.tracer()?.scene === scene) target.onPick(picked);
  };
  watchClicks(canvas, ({ x, y }) => void pick(x, y).catch(target.onError), signal);
  host.addEventListener("keydown", ({ key }) => void (key === "Escape" && target.onPick(undefined)), { signal });
}

/** What the event `pick` tells of a part of the scene, or of none. */
export function pickDetail({ objects, lights }: ResolvedScene, part: ScenePart | undefined): PickDetail {
  if (part === undefined) return { kind: "none" };
  const { kind, index } = part;
  return kind === "object" ? { kind, index, object: objects[index]! } : { kind, index, light: lights[index]! };
}
