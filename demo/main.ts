import "rt-viewer/element";
import { isSoftware, loadInTurn } from "./gallery";
import { takeTurns } from "./turns";

const viewers = [...document.querySelectorAll("rt-viewer")];
const note = document.querySelector<HTMLElement>("#adapter");

const first = viewers[0];
first?.addEventListener("ready", () => {
  const adapter = first.stats?.adapter ?? "";
  const isSlow = isSoftware(adapter);
  if (isSlow) takeTurns(viewers);
  if (note !== null) note.textContent = describe(adapter, isSlow);
});
first?.addEventListener("error", () => {
  if (note !== null) note.textContent = "No picture: this browser gives no WebGPU adapter.";
});

void loadInTurn(viewers);

function describe(adapter: string, isSlow: boolean): string {
  if (!isSlow) return `Running on ${adapter}.`;
  return `Running on ${adapter}: a CPU stands in for the GPU, so the pictures take turns. Point at one to put it first.`;
}
