import { afterAll, beforeAll, beforeEach, expect, test } from "vitest";
import { create } from "webgpu";
import { WebGpuError } from "../../../src/errors";
import { checked, scoped } from "../../../src/gpu/errorScope";
import { BufferUsage } from "../../../src/gpu/flags";

// Dawn's null backend validates everything and computes nothing.
let gpu: GPU; // kept: Dawn crashes when its instance is garbage-collected
let device: GPUDevice;
const uncaptured: string[] = [];

beforeAll(async () => {
  gpu = create(["backend=null"]);
  device = await (await gpu.requestAdapter())!.requestDevice();
  device.addEventListener("uncapturederror", ({ error }) => uncaptured.push(error.message));
});
beforeEach(() => void uncaptured.splice(0));
afterAll(() => device.destroy());

const good = () => device.createBuffer({ size: 16, usage: BufferUsage.STORAGE });
const bad = () => device.createBuffer({ label: "bad", size: 16, usage: 0 });

test("good work gives its value and no error", async () => {
  const { value, error } = scoped(device, good);
  expect(value.size).toBe(16);
  expect(await error).toBeUndefined();
});

test("an error is its owner's, with the browser's as the cause, and nobody else's", async () => {
  const [first, second] = [scoped(device, good), scoped(device, bad)];
  const third = scoped(device, good);
  const error = await second.error;
  expect(error).toBeInstanceOf(WebGpuError);
  expect(error!.cause).toMatchObject({ message: error!.message });
  expect(error!.message).toContain("bad");
  expect([await first.error, await third.error]).toEqual([undefined, undefined]);
  expect(uncaptured).toEqual([]);
});

test("errors outside of the work are not caught by it", async () => {
  const before = bad();
  const { error } = scoped(device, good);
  bad();
  expect(await error).toBeUndefined();
  await device.queue.onSubmittedWorkDone();
  expect(uncaptured).toHaveLength(2);
  before.destroy();
});

test("work within work has its own errors", async () => {
  const outer = scoped(device, () => scoped(device, bad).error);
  expect(await outer.value).toBeInstanceOf(WebGpuError);
  expect(await outer.error).toBeUndefined();
});

test("work that throws leaves no scope behind", async () => {
  const failure = new Error("no");
  const throwing = () => {
    throw failure;
  };
  expect(() => scoped(device, throwing)).toThrow(failure);
  await expect(checked(device, throwing)).rejects.toBe(failure);
  await expect(device.popErrorScope()).rejects.toThrow(); // the stack is empty
});

test("work on a lost device fails nobody here: the loss is told elsewhere", async () => {
  const other = await (await gpu.requestAdapter())!.requestDevice();
  other.destroy();
  await other.lost;
  const usage = BufferUsage.STORAGE;
  expect(await scoped(other, () => other.createBuffer({ size: 16, usage })).error).toBeUndefined();
});
