import { copyText, sayCopied } from "../copying";
import { element } from "../page";
import { type Adapter, openAdapter } from "./adapter";
import { OneAtATime } from "./oneAtATime";
import { RaceView } from "./raceView";
import { resultsText } from "./results";
import { listSettings, TableView } from "./tableView";

listSettings();
const adapter = await openAdapter().catch((error: unknown) => {
  document.body.classList.add("without-adapter");
  element("#adapter").textContent = "none found";
  fail("This page measures the adapter it is looked at with, and here there is none.", error);
});
if (adapter) start(adapter);

function start(adapter: Adapter): void {
  describe(adapter);
  const stage = new OneAtATime();
  const report = (error: unknown) => fail("The measurement broke off.", error);
  const race = new RaceView(adapter, stage, report);
  const table = new TableView(adapter, stage, report);
  void adapter.device.lost.then(({ message }) => fail("The graphics device was lost; reload the page.", message));

  for (const button of document.querySelectorAll<HTMLButtonElement>("[data-copy]")) {
    button.disabled = false;
    button.addEventListener("click", async () => {
      const outcome = await copyText(resultsText(adapter, race.results, table.results), element("#by-hand"));
      if (outcome === "copied") sayCopied(button, "The results are on the clipboard.");
    });
  }

  document.addEventListener("visibilitychange", () => {
    if (document.hidden) stage.stop();
  });
  whenVisible(() => race.run());
}

function describe({ name, isSoftware }: Adapter): void {
  element("#adapter").textContent = name;
  element("#software").hidden = !isSoftware;
}

/** A page opened in the background does not race before it is looked at. */
function whenVisible(action: () => void): void {
  if (document.hidden) document.addEventListener("visibilitychange", action, { once: true });
  else action();
}

function fail(title: string, reason: unknown): void {
  element("#failure-title").textContent = title;
  element("#failure-reason").textContent = reason instanceof Error ? reason.message : String(reason);
  element("#failure").hidden = false;
  element("#failure").scrollIntoView({ block: "nearest" });
}
