/** The box a canvas fills. */
export type CanvasBox = {
  /** CSS pixels. */
  readonly width: number;
  readonly height: number;
  /** Physical pixels per CSS pixel. */
  readonly pixelRatio: number;
  /** Physical pixels, snapped as the compositor snaps them, where the browser tells (`devicePixelContentBoxSize`). */
  readonly device?: PixelSize;
};

/** Whole pixels. */
export type PixelSize = { readonly width: number; readonly height: number };

export type CanvasLimits = {
  /** Of either side; WebGPU guarantees textures of 8192. */
  readonly maxSide: number;
  readonly maxPixels: number;
};

export const DEFAULT_LIMITS: CanvasLimits = {
  maxSide: 8192,
  maxPixels: 2 ** 22, // 16 bytes of film each: 64 MiB, half of the storage binding that every adapter has
};

/**
 * How many pixels to render for a box on the page: its physical pixels, or fewer in the same proportions where that is
 * over a limit. Never less than 1 × 1, so that an element without a layout is still renderable.
 */
export function canvasSize(box: CanvasBox, limits: CanvasLimits = DEFAULT_LIMITS): PixelSize {
  const width = positive(box.device?.width ?? box.width * box.pixelRatio);
  const height = positive(box.device?.height ?? box.height * box.pixelRatio);
  const scale = Math.min(1, limits.maxSide / Math.max(width, height), Math.sqrt(limits.maxPixels / (width * height)));
  // Rounding down once something is capped keeps the product under the cap.
  const round = scale < 1 ? Math.floor : Math.round;
  return { width: Math.max(1, round(width * scale)), height: Math.max(1, round(height * scale)) };
}

/** The box in a `ResizeObserver` entry, as far as the browser tells. */
export function boxOfEntry(entry: ResizeObserverEntry, pixelRatio: number): CanvasBox {
  const { width, height } = entry.contentRect;
  const device = entry.devicePixelContentBoxSize?.[0];
  if (device === undefined) return { width, height, pixelRatio };
  return { width, height, pixelRatio, device: { width: device.inlineSize, height: device.blockSize } };
}

function positive(value: number): number {
  return Number.isFinite(value) && value > 0 ? value : 1;
}
