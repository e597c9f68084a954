import type { Page } from "@playwright/test";

/** What a page has made and not given back. */
export type Holdings = {
  /** Buffers, textures and query sets that were not destroyed, of any device. Pipelines and groups have no `destroy`. */
  readonly gpuObjects: number;
  /** How many of them there have been. */
  readonly gpuObjectsMade: number;
  readonly devices: number;
  readonly devicesMade: number;
  readonly listeners: number;
  readonly listenersMade: number;
  readonly observers: number;
};

/** Counts, from the next page on, what is made and given back. To be called before the page is opened. */
export async function countHoldings(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const live = { gpuObjects: new Set<object>(), devices: new Set<object>(), observers: new Set<object>() };
    const made = { gpuObjects: 0, devices: 0, listeners: 0 };
    type Methods = Record<string, (...args: never[]) => unknown>;
    const wrap = (methods: object, name: string, after: (target: object, result: unknown, args: unknown[]) => void) => {
      const original = (methods as Methods)[name]!;
      (methods as Methods)[name] = function (this: object, ...args: never[]) {
        const result = original.apply(this, args);
        after(this, result, args);
        return result;
      };
    };

    for (const name of ["createBuffer", "createTexture", "createQuerySet"]) {
      wrap(GPUDevice.prototype, name, (_, object) => {
        made.gpuObjects += 1;
        live.gpuObjects.add(object as object);
      });
    }
    for (const { prototype } of [GPUBuffer, GPUTexture, GPUQuerySet]) {
      wrap(prototype, "destroy", (object) => live.gpuObjects.delete(object));
    }
    wrap(GPUAdapter.prototype, "requestDevice", (_, requested) => {
      void (requested as Promise<GPUDevice>).then((device) => {
        made.devices += 1;
        live.devices.add(device);
        void device.lost.then(() => live.devices.delete(device));
      });
    });
    for (const { prototype } of [IntersectionObserver, ResizeObserver, MutationObserver]) {
      wrap(prototype, "observe", (observer) => live.observers.add(observer));
      wrap(prototype, "disconnect", (observer) => live.observers.delete(observer));
    }

    // A listener is one of its target's per type, function and phase; a signal takes away all that were given it.
    const listeners = new Map<EventTarget, Set<string>>();
    const ids = new WeakMap<object, number>();
    let nextId = 0;
    const idOf = (listener: object) => {
      if (!ids.has(listener)) ids.set(listener, nextId++);
      return ids.get(listener)!;
    };
    const { addEventListener } = EventTarget.prototype;
    wrap(EventTarget.prototype, "addEventListener", (target, _, [type, listener, options]) => {
      if (typeof listener !== "function" && typeof listener !== "object") return;
      const { signal, once, capture = false } = Object(options) as AddEventListenerOptions;
      if (listener === null || signal?.aborted) return;
      made.listeners += 1;
      const key = `${type} ${idOf(listener)} ${capture}`;
      const own = listeners.get(target as EventTarget) ?? new Set<string>();
      listeners.set(target as EventTarget, own.add(key));
      const forget = () => void own.delete(key);
      if (signal) addEventListener.call(signal, "abort", forget);
      if (once) addEventListener.call(target, String(type), forget, { once: true });
    });
    wrap(EventTarget.prototype, "removeEventListener", (target, _, [type, listener, options]) => {
      const { capture = options === true } = Object(options) as EventListenerOptions;
      if (listener) listeners.get(target as EventTarget)?.delete(`${type} ${idOf(listener as object)} ${capture}`);
    });
    // An abort signal goes with its controller: listeners to it hold nothing of the page.
    const countListeners = () =>
      [...listeners].reduce((sum, [target, own]) => sum + (target instanceof AbortSignal ? 0 : own.size), 0);

    Object.assign(globalThis, {
      holdings: () => ({
        gpuObjects: live.gpuObjects.size,
        gpuObjectsMade: made.gpuObjects,
        devices: live.devices.size,
        devicesMade: made.devices,
        listeners: countListeners(),
        listenersMade: made.listeners,
        observers: live.observers.size,
      }),
    });
  });
}

export function holdingsOf(page: Page): Promise<Holdings> {
  return page.evaluate(() => (globalThis as unknown as { holdings: () => Holdings }).holdings());
}
