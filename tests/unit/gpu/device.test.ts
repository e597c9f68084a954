import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { WebGpuError } from "../../../src/errors";
import { explainFailure, openDevice, requestDevice } from "../../../src/gpu/device";

type Loss = { readonly reason: string; readonly message: string };
/** What the browser does when it is asked for a device. */
type Answer = "none" | "refuses" | "loses" | "gives";

/** Answers as told, then as it did last. */
function fakeGpu(...answers: readonly Answer[]) {
  const asked: number[] = [];
  const requestAdapter = async () => {
    const answer = answers[Math.min(asked.length, answers.length - 1)]!;
    asked.push(Date.now());
    if (answer === "none") return null;
    const lost = answer === "loses" ? Promise.resolve({ message: "reset" }) : new Promise<Loss>(() => {});
    const requestDevice = async () => {
      if (answer === "refuses") throw new Error("too many");
      return { lost };
    };
    return { limits: {}, features: new Set(), requestDevice };
  };
  return { gpu: { requestAdapter } as unknown as GPU, asked };
}

beforeEach(() => void vi.useFakeTimers());
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

/** Lets time pass until it is settled, and tells how many milliseconds that took. */
async function settle<T>(promise: Promise<T>): Promise<{ value?: T; error?: Error; ms: number }> {
  const start = Date.now();
  const settled = promise.then(
    (value) => ({ value, ms: Date.now() - start }),
    (error: Error) => ({ error, ms: Date.now() - start }),
  );
  await vi.advanceTimersByTimeAsync(60_000);
  return settled;
}

describe("requesting a device", () => {
  test.each<[string, Answer]>([
    ["an adapter that is not there yet", "none"],
    ["an adapter that refuses", "refuses"],
    ["a device that is lost at once", "loses"],
  ])("%s is asked for again until there is one", async (_, answer) => {
    const { gpu, asked } = fakeGpu(answer, answer, "gives");
    vi.stubGlobal("navigator", { gpu });
    const { value, ms } = await settle(requestDevice());
    expect(value).toBeDefined();
    expect(asked).toHaveLength(3);
    expect(ms).toBeLessThan(1000);
  });

  test.each<[Answer, RegExp]>([
    ["none", /no graphics adapter/],
    ["refuses", /refused to open a device/],
    ["loses", /lost as soon as it was opened: reset/],
  ])("where it always %s, that is told within two seconds and some", async (answer, message) => {
    const { gpu, asked } = fakeGpu(answer);
    vi.stubGlobal("navigator", { gpu });
    const { error, ms } = await settle(requestDevice());
    expect(error).toBeInstanceOf(WebGpuError);
    expect(error!.message).toMatch(message);
    expect(asked).toHaveLength(5);
    expect(ms).toBeGreaterThanOrEqual(1000);
    expect(ms).toBeLessThan(2500);
  });

  test("one that lives is given at the first attempt, and without WebGPU nobody waits", async () => {
    const { gpu, asked } = fakeGpu("gives");
    vi.stubGlobal("navigator", { gpu });
    expect((await settle(requestDevice())).ms).toBe(0);
    expect(asked).toHaveLength(1);
    vi.stubGlobal("navigator", {});
    expect(await settle(requestDevice())).toMatchObject({ error: expect.any(WebGpuError), ms: 0 });
  });

  test("the command line, which has no GPU process to wait for, asks once", async () => {
    const { gpu, asked } = fakeGpu("none");
    expect(await settle(openDevice(gpu))).toMatchObject({ error: expect.any(WebGpuError), ms: 0 });
    expect(asked).toHaveLength(1);
  });
});

describe("why work on a device failed", () => {
  const deviceThat = (lost: Promise<unknown>) => ({ lost }) as GPUDevice;

  test("its loss comes before what the browser says about the work, and may be told a moment later", async () => {
    const lost = new Promise((resolve) => setTimeout(resolve, 50, { reason: "unknown", message: "reset" }));
    const abort = new DOMException("The Device was lost before mapping was resolved.", "AbortError");
    const { value } = await settle(explainFailure(deviceThat(lost), abort));
    expect(value).toBeInstanceOf(WebGpuError);
    expect(value!.message).toBe("The GPU device was lost: reset");
  });

  test("what the browser throws becomes the cause of an error of ours", async () => {
    const cause = new DOMException("no", "OperationError");
    const { value } = await settle(explainFailure(deviceThat(new Promise(() => {})), cause));
    expect(value).toBeInstanceOf(WebGpuError);
    expect(value).toMatchObject({ message: "no", cause });
  });
});
