/** What loads faster is not worth a word, in milliseconds. */
const SLOW_LOAD_MS = 1000;

/**
 * Tells those who do not see the picture how far it is: that it loads, if that takes long, and when it is finished. Once
 * per scene each; errors have the message's own role `alert`.
 */
export class LiveRegion {
  readonly element: HTMLElement;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #isFinished = false;

  constructor(document: Document) {
    this.element = document.createElement("div");
    this.element.className = "unseen";
    this.element.setAttribute("role", "status");
  }

  /** A scene has been asked for. */
  noteLoading(): void {
    this.clear();
    this.#timer = setTimeout(() => this.#say("Loading the scene"), SLOW_LOAD_MS);
  }

  /** Its first picture is there. */
  noteReady(): void {
    clearTimeout(this.#timer);
    if (this.element.textContent !== "") this.#say("The picture is there and gets finer");
  }

  /** The picture is as good as it was to be. */
  noteConverged(): void {
    if (this.#isFinished) return;
    this.#isFinished = true;
    this.#say("The picture is finished");
  }

  /** There is nothing to tell any more. */
  clear(): void {
    clearTimeout(this.#timer);
    this.#isFinished = false;
    this.#say("");
  }

  #say(text: string): void {
    this.element.textContent = text;
  }
}
