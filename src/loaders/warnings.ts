// A place is named by its index and, where it has one, its name; more than this many are counted.
const MAX_NAMED_PLACES = 3;
// Of different texts, which can have numbers of the file in them.
const MAX_LINES = 100;

/** Collects what a loader could not honour: one line per kind of trouble, with the places where it occurs. */
export class Warnings {
  readonly #places = new Map<string, Set<string>>();

  /**
   * @param text - says what is not supported and what is shown instead; the same for every place.
   * @param place - where, as `materials[3] "Glass"`.
   */
  add(text: string, place?: string): void {
    const places = this.#places.get(text) ?? new Set();
    if (place !== undefined) places.add(place);
    this.#places.set(text, places);
  }

  list(): string[] {
    const lines = [...this.#places]
      .slice(0, MAX_LINES)
      .map(([text, places]) => (places.size === 0 ? text : `${text} (${listed([...places])})`));
    const rest = this.#places.size - lines.length;
    return rest > 0 ? [...lines, `… and ${rest} more`] : lines;
  }
}

/** The first few, and how many more there are. */
export function listed(places: readonly string[]): string {
  const named = places.slice(0, MAX_NAMED_PLACES).join(", ");
  const rest = places.length - MAX_NAMED_PLACES;
  return rest > 0 ? `${named} and ${rest} more` : named;
}
