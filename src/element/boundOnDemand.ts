/** What is bound to the element while it is wanted, such as the controls; its code is loaded when it is first wanted. */
export class BoundOnDemand {
  readonly #isWanted: () => boolean;
  readonly #bind: (signal: AbortSignal) => Promise<void>;
  readonly #onError: (error: Error) => void;
  #binding: AbortController | undefined;

  /** @param bind - loads the code and binds, unless the signal, which ends it, is aborted by then. */
  constructor(isWanted: () => boolean, bind: (signal: AbortSignal) => Promise<void>, onError: (error: Error) => void) {
    this.#isWanted = isWanted;
    this.#bind = bind;
    this.#onError = onError;
  }

  /** Binds it anew, or no more. */
  rebind(): void {
    this.unbind();
    if (!this.#isWanted()) return;
    this.#binding = new AbortController();
    this.#bind(this.#binding.signal).catch(this.#onError);
  }

  unbind(): void {
    this.#binding?.abort();
    this.#binding = undefined;
  }
}
