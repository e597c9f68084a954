import type { Shared } from "./link";

/** Scenes to start from: the gallery's, by the names of their files. */
export const EXAMPLES = [
  { name: "spheres", title: "Three balls, one lamp", exposure: 0 },
  { name: "cornell", title: "Cornell box", exposure: 0 },
  { name: "bleed", title: "A red ball", exposure: 1.5 },
  { name: "veach", title: "Four lamps, four plates", exposure: 1 },
  { name: "furnace", title: "White balls in a white room", exposure: 0 },
] as const;

/** @throws {Error} naming the file that could not be loaded. */
export async function loadExample(name: string, format: (scene: unknown) => string): Promise<Shared> {
  const { exposure } = EXAMPLES.find((example) => example.name === name) ?? EXAMPLES[0];
  const path = `scenes/${name}.json`;
  const response = await fetch(path);
  if (!response.ok) throw new Error(`${path} could not be loaded: ${response.status} ${response.statusText}`);
  return { text: format(await response.json()), exposure };
}
