import type { LoadProgressDetail } from "./loadProgress";

/**
 * What lies over the canvas until there is a picture: the poster, and a thin bar that says how far the scene is. The bar
 * also shows while another scene is made ready behind the picture there is.
 */
export class Curtain {
  readonly element: HTMLElement;
  readonly #poster: HTMLElement;
  readonly #image: HTMLImageElement;
  readonly #bar: HTMLElement;
  readonly #filled: HTMLElement;

  constructor(document: Document) {
    this.element = document.createElement("div");
    this.element.className = "curtain";

    this.#image = document.createElement("img");
    this.#image.setAttribute("part", "poster");
    this.#image.alt = ""; // the canvas says what it is a picture of
    this.#image.hidden = true;
    const slot = document.createElement("slot");
    slot.name = "poster";
    slot.append(this.#image);
    this.#poster = document.createElement("div");
    this.#poster.className = "poster";
    this.#poster.append(slot);

    this.#filled = document.createElement("div");
    this.#bar = document.createElement("div");
    this.#bar.className = "progress";
    this.#bar.setAttribute("part", "progress");
    this.#bar.setAttribute("role", "progressbar");
    this.#bar.setAttribute("aria-label", "Loading");
    this.#bar.hidden = true;
    this.#bar.append(this.#filled);
    this.element.append(this.#poster, this.#bar);
  }

  /** @param src - URL of an image, "" for none; `loading` as that of an `img`. */
  setPoster(src: string, loading: "eager" | "lazy"): void {
    this.#image.loading = loading;
    this.#image.hidden = src === "";
    if (src === "") this.#image.removeAttribute("src");
    else if (this.#image.getAttribute("src") !== src) this.#image.src = src;
  }

  showProgress({ fraction }: LoadProgressDetail): void {
    this.#bar.hidden = false;
    this.#bar.classList.toggle("unknown", fraction === undefined);
    this.#filled.style.transform = fraction === undefined ? "" : `scaleX(${fraction})`;
    this.#bar.ariaValueNow = fraction === undefined ? null : String(Math.round(100 * fraction));
  }

  hideProgress(): void {
    this.#bar.hidden = true;
  }

  /** There is a picture. */
  open(): void {
    this.hideProgress();
    this.#poster.classList.add("gone");
  }

  /** There is none any more. */
  close(): void {
    this.hideProgress();
    this.#poster.classList.remove("gone");
  }
}
