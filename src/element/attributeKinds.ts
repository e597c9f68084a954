import type { NumberRange } from "../renderer/checkSettings";

/** How a property is kept in an attribute. */
export type Reflection<Value> = {
  readonly attribute: string;
  /** Forgiving, as in HTML: what makes no sense counts as absent. */
  read(element: Element): Value;
  write(element: Element, value: Value): void;
};

/** Any text; absent is "". */
export function text(attribute: string): Reflection<string> {
  return {
    attribute,
    read: (element) => element.getAttribute(attribute) ?? "",
    write: (element, value) => element.setAttribute(attribute, value),
  };
}

/** Any text; absent is null, which removes the attribute. */
export function textOrNull(attribute: string): Reflection<string | null> {
  return {
    attribute,
    read: (element) => element.getAttribute(attribute),
    write(element, value) {
      if (value === undefined || value === null) element.removeAttribute(attribute);
      else element.setAttribute(attribute, value);
    },
  };
}

/** There or not there, whatever its text, which stays as it is as long as the attribute is there. */
export function flag(attribute: string): Reflection<boolean> {
  return {
    attribute,
    read: (element) => element.hasAttribute(attribute),
    write: (element, value) => void element.toggleAttribute(attribute, Boolean(value)),
  };
}

/** One of a few words. */
export function keyword<Word extends string>(
  attribute: string,
  words: readonly Word[],
  fallback: Word,
): Reflection<Word> {
  return {
    attribute,
    read: (element) => parseKeyword(element.getAttribute(attribute), words, fallback),
    write: (element, value) => element.setAttribute(attribute, value),
  };
}

/** A number. */
export function number(attribute: string, range: NumberRange, fallback: number): Reflection<number> {
  return {
    attribute,
    read: (element) => parseNumber(element.getAttribute(attribute), range) ?? fallback,
    write: (element, value) => element.setAttribute(attribute, String(value)),
  };
}

/** A number, or whatever else the fallback is; `undefined` removes the attribute. */
export function numberOr<Fallback>(
  attribute: string,
  range: NumberRange,
  fallback: Fallback,
): Reflection<number | Fallback> {
  return {
    attribute,
    read: (element) => parseNumber(element.getAttribute(attribute), range) ?? fallback,
    write(element, value) {
      if (value === undefined || value === null) element.removeAttribute(attribute);
      else element.setAttribute(attribute, String(value));
    },
  };
}

/** Reads one of a few words, whatever its case. An absent or other one is the fallback. */
export function parseKeyword<T extends string>(text: string | null, words: readonly T[], fallback: T): T {
  const wanted = text?.trim().toLowerCase();
  return words.find((word) => word === wanted) ?? fallback;
}

/**
 * Reads a number as HTML does, forgivingly: an absent, malformed or out-of-range value is `undefined` and the default
 * applies.
 */
export function parseNumber(text: string | null, rule: NumberRange): number | undefined {
  if (text === null || text.trim() === "") return undefined;
  const value = Number(text);
  if (!(value >= rule.min && value <= rule.max)) return undefined;
  if (rule.isInteger && !Number.isInteger(value) && value !== Number.POSITIVE_INFINITY) return undefined;
  return value;
}
