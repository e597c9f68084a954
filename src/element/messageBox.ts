import type { ErrorText } from "./describeError";

/**
 * The place in the element where it says in words why there is no picture. What the page has put into the slot `fallback`
 * is shown instead, unless the scene itself is at fault: its author has to see that.
 */
export class MessageBox {
  readonly element: HTMLElement;
  readonly #slot: HTMLSlotElement;

  constructor(document: Document) {
    this.#slot = document.createElement("slot");
    this.#slot.name = "fallback";
    this.element = document.createElement("div");
    this.element.className = "message";
    this.element.setAttribute("part", "message");
    this.element.setAttribute("role", "alert");
    this.element.tabIndex = 0; // a long list is scrolled by keyboard too
    this.element.hidden = true;
  }

  get isShown(): boolean {
    return !this.element.hidden;
  }

  /** Every text is set as text: nothing in a scene file is ever treated as HTML. */
  show(text: ErrorText): void {
    const { ownerDocument } = this.element;
    const title = ownerDocument.createElement("p");
    title.textContent = text.title;
    const list = ownerDocument.createElement("ul");
    for (const line of text.lines) {
      const item = ownerDocument.createElement("li");
      item.textContent = line;
      list.append(item);
    }
    const words = ownerDocument.createElement("div");
    words.append(title, list);
    this.#slot.replaceChildren();
    if (!text.isCode) this.#slot.append(words);
    this.element.replaceChildren(text.isCode ? words : this.#slot);
    this.element.classList.toggle("code", text.isCode === true);
    this.element.hidden = false;
  }

  clear(): void {
    this.element.hidden = true;
    this.element.replaceChildren();
  }
}
