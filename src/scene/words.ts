// Fields that are words.

import * as v from "valibot";
import { oneOf, show, suggest } from "./describe";

/** True or false, by default false. */
export const flag = v.optional(
  v.boolean((issue) => `expected true or false, got ${show(issue.input)}`),
  false,
);

/** One of several words, the first by default. */
export function choice<const Word extends string>(words: readonly Word[], initial: NoInfer<Word>) {
  const expected = oneOf(words);
  const picklist = v.picklist(words, ({ input }) => `expected ${expected}, got ${show(input)}${suggest(input, words)}`);
  return v.optional(picklist, initial);
}
