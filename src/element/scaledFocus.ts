import type { ResolvedCamera } from "../scene/schema";

/**
 * Where a camera with a lens focuses once it is `factor` times as far from its target: what is sharp at the target stays so. Empty
 * where the target is always in focus.
 */
export function scaledFocus({ focusDistance }: ResolvedCamera, factor: number): Pick<ResolvedCamera, "focusDistance"> {
  return focusDistance === undefined ? {} : { focusDistance: focusDistance * factor };
}
