import type { ErrorText } from "./describeError";

/** The place in the element where it says in words why there is no picture. */
export class MessageBox {
  readonly element: HTMLElement;

  constructor(document: Document) {
    this.element = document.createElement("div");
    this.element.className = "message";
    this.element.setAttribute("part", "message");
    this.element.setAttribute("role", "alert");
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
    this.element.replaceChildren(title, list);
    this.element.classList.toggle("code", text.isCode === true);
    this.element.hidden = false;
  }

  clear(): void {
    this.element.hidden = true;
    this.element.replaceChildren();
  }
}
