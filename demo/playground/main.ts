import schema from "rt-viewer/scene.schema.json";
import "rt-viewer/element";
import { copyText, sayCopied } from "../copying";
import { element } from "../page";
import type { Checked, Problem } from "./check";
import { createEditor, replaceText } from "./editor";
import { EXAMPLES, loadExample } from "./examples";
import { formatScene } from "./formatScene";
import { fromHash, LinkError, type Shared, toHash } from "./link";
import { showProblems } from "./problemList";
import { wholeTree } from "./wholeTree";
import { withCamera } from "./withCamera";

const viewer = document.querySelector("rt-viewer")!;
const examples = element<HTMLSelectElement>("#examples");
const share = element<HTMLButtonElement>("#share");
const editor = createEditor({ parent: element("#editor"), schema, onCheck: show });

examples.append(...EXAMPLES.map(({ name, title }) => new Option(title, name)));
examples.addEventListener("change", () => open(() => loadExample(examples.value, formatScene)));
addEventListener("hashchange", () => {
  if (/^#(scene|example)=/.test(location.hash)) open(fromAddress); // and not for the skip link
});
element("#view").addEventListener("click", takeView);
share.addEventListener("click", copyLink);
await open(fromAddress);

/** What the address holds: `#scene=…`, or `#example=NAME`; without anything in it, the first example. */
async function fromAddress(): Promise<Shared> {
  const wanted = new URLSearchParams(location.hash.slice(1)).get("example");
  const example = EXAMPLES.find(({ name }) => name === wanted) ?? EXAMPLES[0];
  examples.value = example.name;
  try {
    const shared = await fromHash(location.hash);
    if (shared === undefined) return loadExample(example.name, formatScene);
    examples.value = "";
    return shared;
  } catch (error) {
    if (!(error instanceof LinkError)) throw error;
    notify(`${error.message} Here is an example instead.`);
    return loadExample(example.name, formatScene);
  }
}

async function open(load: () => Promise<Shared>): Promise<void> {
  notify("");
  try {
    const { text, exposure } = await load();
    viewer.exposure = exposure;
    replaceText(editor, text);
  } catch (error) {
    notify(error instanceof Error ? error.message : String(error));
  }
}

/** The picture follows the text as long as the text is a scene. */
function show({ problems, scene }: Checked): void {
  const count = problems.length === 1 ? "1 mistake" : `${problems.length} mistakes`;
  element("#status").textContent =
    problems.length === 0 ? "No mistakes." : `${count}. The picture shows the last scene without any.`;
  element("#problems").hidden = problems.length === 0;
  showProblems(element("#problems"), problems, (position) => editor.state.doc.lineAt(position).number, goTo);
  if (scene !== undefined && JSON.stringify(scene) !== JSON.stringify(viewer.scene)) viewer.scene = scene;
}

function goTo({ from, to }: Problem): void {
  editor.dispatch({ selection: { anchor: from, head: to }, scrollIntoView: true });
  editor.focus();
}

function takeView(): void {
  const change = viewer.camera && withCamera(viewer.camera, editor.state.doc.toString(), wholeTree(editor.state));
  if (change) editor.dispatch({ changes: change, scrollIntoView: true });
}

async function copyLink(): Promise<void> {
  try {
    const hash = await toHash({ text: editor.state.doc.toString(), exposure: viewer.exposure });
    history.replaceState(undefined, "", hash);
    notify("");
    const outcome = await copyText(location.href, element("#by-hand"));
    if (outcome === "copied") sayCopied(share, "The link is on the clipboard.");
  } catch (error) {
    notify(error instanceof Error ? error.message : String(error));
  }
}

/** Says what went wrong; `""` takes it back. */
function notify(message: string): void {
  element("#notice").textContent = message;
  element("#notice").hidden = message === "";
}
