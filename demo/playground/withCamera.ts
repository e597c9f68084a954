import type { Tree } from "@lezer/common";
import type { Camera } from "rt-viewer";
import { formatScene } from "./formatScene";
import { child, rootValue, valueIn } from "./jsonPosition";

const DIGITS = 1e4; // a tenth of a millimetre

/** The change that makes a text's camera this one; `undefined` if the text has none. */
export function withCamera(camera: Camera, text: string, tree: Tree) {
  const root = rootValue(tree);
  const property = root && child(root, "camera", text);
  const value = property && valueIn(property);
  if (value === undefined) return undefined;
  const rounded = JSON.stringify(camera, (_, item: unknown) =>
    typeof item === "number" ? Math.round(item * DIGITS) / DIGITS : item,
  );
  const [first, ...rest] = formatScene(JSON.parse(rounded)).trimEnd().split("\n");
  return { from: value.from, to: value.to, insert: [first, ...rest.map((line) => `  ${line}`)].join("\n") };
}
