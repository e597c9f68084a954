import { expect, it } from "vitest";
import { SceneEdits } from "../../../src/element/sceneEdits";
import { parseCamera } from "../../../src/scene/parseScene";
import type { Camera, Scene } from "../../../src/scene/schema";

/** A tracer that takes as long to show a scene as the test wants, and then looks at it as its author did. */
function fakeTracer() {
  const shown: Scene[] = [];
  const gates: { open: () => void; fail: (error: Error) => void }[] = [];
  return {
    shown,
    gates,
    camera: parseCamera({ position: [1, 2, 3] }),
    setScene(scene: Scene, { camera = scene.camera }: { readonly camera?: Camera }): Promise<void> {
      shown.push(scene);
      this.camera = parseCamera(camera);
      return new Promise((open, fail) => void gates.push({ open, fail }));
    },
  };
}

const sceneOf = (maxBounces: number): Scene => ({ camera: { position: [0, 0, 9] }, objects: [], maxBounces });

it("of edits that come while one is compiled, the last one is shown next", async () => {
  const tracer = fakeTracer();
  const edits = new SceneEdits(tracer);
  const done = edits.show(sceneOf(1));
  for (const bounces of [2, 3, 4]) void edits.show(sceneOf(bounces));
  expect(tracer.shown.map(({ maxBounces }) => maxBounces)).toEqual([1]);
  tracer.gates[0]!.open();
  await expect.poll(() => tracer.shown.length).toBe(2);
  tracer.gates[1]!.open();
  await done;
  expect(tracer.shown.map(({ maxBounces }) => maxBounces)).toEqual([1, 4]);
});

it("the camera stays where it is, from the first moment on", () => {
  const tracer = fakeTracer();
  void new SceneEdits(tracer).show(sceneOf(1));
  expect(tracer.camera.position).toEqual([1, 2, 3]);
});

it("what is waiting can be dropped", async () => {
  const tracer = fakeTracer();
  const edits = new SceneEdits(tracer);
  const done = edits.show(sceneOf(1));
  void edits.show(sceneOf(2));
  edits.cancel();
  tracer.gates[0]!.open();
  await done;
  expect(tracer.shown).toHaveLength(1);
});

it("after a failure it goes on with the next edit", async () => {
  const tracer = fakeTracer();
  const edits = new SceneEdits(tracer);
  const failed = edits.show(sceneOf(1));
  tracer.gates[0]!.fail(new Error("no"));
  await expect(failed).rejects.toThrow("no");
  void edits.show(sceneOf(2));
  expect(tracer.shown.map(({ maxBounces }) => maxBounces)).toEqual([1, 2]);
});
