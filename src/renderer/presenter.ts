import type { Film } from "../gpu/film";
import type { DeviceGuard } from "./deviceGuard";
import { Display } from "./display";
import type { View } from "./view";

/** Draws films on a canvas. What that takes is compiled with the first picture, for the format of its canvas. */
export class Presenter {
  readonly #guard: DeviceGuard;
  #display: Display | Promise<void> | undefined;
  #isDisposed = false;

  constructor(guard: DeviceGuard) {
    this.#guard = guard;
  }

  /**
   * @returns whether it drew: not until that is compiled.
   * @throws {UnsupportedError} if the film or the canvas is larger than a texture of the device.
   */
  present(film: Film, context: GPUCanvasContext, view: View): boolean {
    const display = this.#display;
    if (display instanceof Display) {
      this.#guard.run(() => display.draw(film, context.getCurrentTexture(), view));
      return true;
    }
    this.#display ??= this.#createDisplay(context.getConfiguration()!.format).catch(this.#guard.fail);
    return false;
  }

  dispose(): void {
    this.#isDisposed = true;
    if (this.#display instanceof Display) this.#display.dispose();
  }

  async #createDisplay(format: GPUTextureFormat): Promise<void> {
    const display = await Display.create(this.#guard.device, format);
    if (this.#isDisposed) display.dispose();
    else this.#display = display;
  }
}
