import { createKeyHelp, labelCanvas } from "./canvasLabel";
import { Curtain } from "./curtain";
import { describeError } from "./describeError";
import { LiveRegion } from "./liveRegion";
import type { LoadProgressDetail } from "./loadProgress";
import { MessageBox } from "./messageBox";
import { elementStyles } from "./styles";

/** What a visitor sees of the element, or hears read: the picture, and what is shown or said in its place. */
export class Face {
  readonly root: ShadowRoot;
  readonly canvas: HTMLCanvasElement;
  /** Where the panel goes. */
  readonly corner: HTMLElement;
  readonly #curtain: Curtain;
  readonly #message: MessageBox;
  readonly #liveRegion: LiveRegion;

  /** @param element - is given a shadow root. */
  constructor(element: HTMLElement) {
    const { ownerDocument } = element;
    this.root = element.attachShadow({ mode: "open", delegatesFocus: true });
    this.root.adoptedStyleSheets = [elementStyles()];
    this.canvas = ownerDocument.createElement("canvas");
    this.canvas.setAttribute("part", "canvas");
    this.#curtain = new Curtain(ownerDocument);
    this.#liveRegion = new LiveRegion(ownerDocument);
    this.#message = new MessageBox(ownerDocument);
    this.corner = ownerDocument.createElement("div");
    this.corner.className = "panel";
    this.corner.setAttribute("part", "panel");
    this.root.append(
      this.canvas,
      this.#curtain.element,
      this.corner,
      this.#message.element,
      this.#liveRegion.element,
      createKeyHelp(ownerDocument),
    );
  }

  /** Whether a message stands in place of the picture. */
  get hasMessage(): boolean {
    return this.#message.isShown;
  }

  /**
   * Says what the picture is, and whether it takes keys.
   *
   * @param alt - what it shows, "" where nobody says.
   */
  describe(alt: string, hasControls: boolean): void {
    if (hasControls) this.canvas.tabIndex = 0;
    else this.canvas.removeAttribute("tabindex");
    labelCanvas(this.canvas, alt, hasControls);
  }

  /** @param src - URL of an image, "" for none; `loading` as that of an `img`. */
  setPoster(src: string, loading: "eager" | "lazy"): void {
    this.#curtain.setPoster(src, loading);
  }

  /** A scene has been asked for. */
  noteLoading(): void {
    this.#liveRegion.noteLoading();
  }

  showProgress(detail: LoadProgressDetail): void {
    this.#curtain.showProgress(detail);
  }

  hideProgress(): void {
    this.#curtain.hideProgress();
  }

  /** There is a picture. */
  noteReady(): void {
    this.#curtain.open();
    this.#liveRegion.noteReady();
  }

  /** The picture is as good as it was to be. */
  noteConverged(): void {
    this.#liveRegion.noteConverged();
  }

  /** Says in place of the picture why there is none. */
  showError(error: Error): void {
    this.#message.show(describeError(error));
    this.canvas.inert = true;
    this.#curtain.hideProgress();
    this.#liveRegion.clear();
  }

  clearMessage(): void {
    this.#message.clear();
    this.canvas.inert = false;
  }

  /** There is no picture any more, and nothing to say about it. */
  clear(): void {
    this.clearMessage();
    this.#curtain.close();
    this.#liveRegion.clear();
  }
}
