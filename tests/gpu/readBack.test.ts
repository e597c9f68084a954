import { expect, test } from "vitest";
import { PathTracer } from "../../src/renderer/pathTracer";
import { testDevice } from "../support/device";
import { loadReference } from "../support/reference";

const { scene } = loadReference("cornell");

async function createTracer(): Promise<PathTracer> {
  return PathTracer.create({ scene, width: 24, height: 16, device: await testDevice() });
}

const changes: Readonly<Record<string, (tracer: PathTracer) => void>> = {
  "the film is cleared": (tracer) => {
    tracer.reset();
    tracer.frame();
  },
  "the size changes": (tracer) => tracer.resize(12, 8),
  "more is sampled": (tracer) => void tracer.sample(8),
  "the tracer is disposed of": (tracer) => tracer.dispose(),
};

test.each(Object.keys(changes))(
  "what is read is of the moment of the call, though %s right after it, seed 1",
  async (name) => {
    const tracer = await createTracer();
    await tracer.sample(4);
    const expected = [await tracer.readRadiance(), await tracer.readPicture()];
    expect(expected[1]!.some((value, i) => i % 4 < 3 && value > 0)).toBe(true);
    const read = [tracer.readRadiance(), tracer.readPicture()];
    changes[name]!(tracer);
    expect(await Promise.all(read)).toEqual(expected);
    tracer.dispose();
  },
);
