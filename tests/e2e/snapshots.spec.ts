import type { RtViewerElement } from "../../src/element";
import { collectGpuErrors, gpuErrorsOf } from "./support/gpuErrors";
import { report } from "./support/report";
import { expect, test } from "./support/test";
import { addViewer, openViewer, waitForSamples } from "./support/viewer";

const SMALL = { src: "spheres.json", style: "width:160px;height:120px" };

test("toBlob, screenshot, readRadiance and pick outlive sizes, scales, moves, removals and losses", async ({
  page,
}) => {
  test.slow();
  await collectGpuErrors(page);
  await openViewer(page, { ...SMALL, id: "viewer" });
  await addViewer(page, { ...SMALL, id: "neighbour" });
  const [viewer, neighbour] = [page.locator("#viewer"), page.locator("#neighbour")];
  await waitForSamples(neighbour, 1);
  const seen = await page.evaluate(async () => {
    const ROUNDS = 24;
    const viewer = document.querySelector<RtViewerElement>("#viewer")!;
    const outcomes = { fulfilled: 0, rejected: {} as Record<string, number>, foreign: [] as string[] };
    const refusal: unknown = await viewer.open(new Blob(["no scene"])).catch((error: unknown) => error);
    const RtViewerError = Object.getPrototypeOf(Object(refusal).constructor) as new () => Error;
    const wait = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));
    const hasPicture = async () => {
      for (const until = performance.now() + 8000; performance.now() < until; await wait(10)) {
        if ((viewer.stats?.samples ?? 0) > 0) return;
      }
      throw new Error("the viewer shows no picture any more");
    };
    const calls: readonly (() => unknown)[] = [
      () => viewer.toBlob(),
      () => viewer.toBlob("image/jpeg", 0.5),
      () => viewer.screenshot("pfm"),
      () => viewer.readRadiance(),
      () => viewer.tracer?.pick(80, 60),
    ];
    const section = document.body.appendChild(document.createElement("section"));
    const changes: readonly ((round: number) => unknown)[] = [
      (round) => (viewer.style.width = `${100 + ((round * 37) % 90)}px`),
      (round) => (viewer.style.zoom = String(1 + (round % 3) / 4)),
      () => (viewer.parentNode === section ? document.body : section).append(viewer),
      () => viewer.reset(),
      (round) => viewer.setAttribute("src", round % 2 ? "spheres.json" : "furnace.json"),
      async () => {
        viewer.remove();
        await wait(30); // longer than the grace
        document.body.append(viewer);
      },
    ];
    const pending: Promise<void>[] = [];
    const call = () => {
      for (const method of calls) {
        const called = (async () => method())();
        const note = called.then(
          () => {
            outcomes.fulfilled += 1;
          },
          (error: Error) => {
            const isOurs: boolean = error instanceof RtViewerError;
            if (!isOurs) outcomes.foreign.push(`${error.name}: ${error.message}`);
            outcomes.rejected[error.message] = (outcomes.rejected[error.message] ?? 0) + 1;
          },
        );
        pending.push(note);
      }
    };
    for (let round = 0; round < ROUNDS; round++) {
      if (round % 4 !== 3) await hasPicture();
      call();
      await changes[round % changes.length]!(round);
      if (round % 10 === 9) viewer.tracer?.device.destroy();
      call();
      await wait((round * 7) % 40);
      call();
    }
    await Promise.all(pending);
    return { ...outcomes, callCount: pending.length };
  });
  report("snapshot-storm", seen);
  expect(seen.foreign).toEqual([]);
  expect(seen.fulfilled).toBeGreaterThan(60);
  expect(await gpuErrorsOf(page)).toEqual({ uncaptured: [], captured: [] });
  for (const each of [viewer, neighbour]) {
    await waitForSamples(each, 2);
    await expect(each.getByRole("alert")).toBeHidden();
  }
});

test("a blob that is asked for when the device is lost is refused with an error of ours", async ({ page }) => {
  const viewer = await openViewer(page, SMALL);
  const names = await viewer.evaluate(async (element: RtViewerElement) => {
    const nameOf = (error: Error) => error.name;
    const earlier = element.toBlob().then(() => "blob", nameOf);
    element.tracer!.device.destroy();
    return [await earlier, await element.toBlob().then(() => "blob", nameOf)];
  });
  for (const name of names) expect(["WebGpuError", "RtViewerError"]).toContain(name);
  await waitForSamples(viewer, 2);
});

test("a blob is of the moment of the call, though the scene changes right after it", async ({ page }) => {
  const viewer = await openViewer(page, { ...SMALL, "max-samples": "4" }, 4);
  const sizes = await viewer.evaluate(async (element: RtViewerElement) => {
    const bytesOf = async (blob: Promise<Blob>) => [...new Uint8Array(await (await blob).arrayBuffer())].join();
    const expected = await bytesOf(element.toBlob());
    const blob = bytesOf(element.toBlob());
    element.camera = { position: [0, 5, 1] };
    element.style.width = "100px";
    element.setAttribute("src", "furnace.json");
    return { isEqual: (await blob) === expected, length: expected.length };
  });
  expect(sizes.isEqual).toBe(true);
  expect(sizes.length).toBeGreaterThan(1000);
});
