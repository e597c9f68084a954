import { show } from "../scene/describe";

/** A file can have thousands. */
const MAX_NAMED = 20;

/**
 * Says which variants a file has, where one was asked for that it does not have.
 *
 * @param file - its subject: "The file", or a name.
 */
export function missingVariant(file: string, wanted: string, variants: readonly string[]): string {
  const named = variants.slice(0, MAX_NAMED).map(show);
  if (variants.length > MAX_NAMED) named.push(`${variants.length - MAX_NAMED} more`);
  return `${file} has no variant ${show(wanted)}: it has ${named.length === 0 ? "none" : named.join(", ")}`;
}
