import { expect, it } from "vitest";
import { LatestTask } from "../../../src/element/latestTask";

/** A promise that the test settles. */
function deferred<T>() {
  let resolve!: (value: T) => void;
  let reject!: (error: Error) => void;
  const promise = new Promise<T>((yes, no) => {
    resolve = yes;
    reject = no;
  });
  return { promise, resolve, reject };
}

it("carries out a task and tells so", async () => {
  const done: string[] = [];
  const task = new LatestTask();
  const isLast = await task.run(
    async () => "a",
    async (value) => void done.push(value),
  );
  expect(isLast).toBe(true);
  expect(done).toEqual(["a"]);
});

it("the last one holds, whatever order the downloads finish in", async () => {
  const [slow, quick] = [deferred<string>(), deferred<string>()];
  const done: string[] = [];
  const task = new LatestTask();
  const first = task.run(
    () => slow.promise,
    async (value) => void done.push(value),
  );
  const second = task.run(
    () => quick.promise,
    async (value) => void done.push(value),
  );
  quick.resolve("second");
  await second;
  slow.resolve("first");
  expect(await first).toBe(false);
  expect(done).toEqual(["second"]);
});

it("aborts the download of the one that is overtaken", async () => {
  const task = new LatestTask();
  let signal: AbortSignal | undefined;
  const first = task.run(
    (given) => {
      signal = given;
      return deferred<string>().promise;
    },
    async () => undefined,
  );
  void first;
  await task.run(
    async () => "second",
    async () => undefined,
  );
  expect(signal?.aborted).toBe(true);
});

it("commits never overlap", async () => {
  const task = new LatestTask();
  const gate = deferred<void>();
  const log: string[] = [];
  const commit = async (value: string) => {
    log.push(`${value} begins`);
    if (value === "first") await gate.promise;
    log.push(`${value} ends`);
  };
  const first = task.run(async () => "first", commit);
  await Promise.resolve();
  await Promise.resolve();
  const second = task.run(async () => "second", commit);
  await new Promise((resolve) => setImmediate(resolve));
  expect(log).toEqual(["first begins"]);
  gate.resolve();
  expect(await Promise.all([first, second])).toEqual([false, true]);
  expect(log).toEqual(["first begins", "first ends", "second begins", "second ends"]);
});

it("an error of an overtaken task is nobody's business, that of the last one is", async () => {
  const task = new LatestTask();
  const failing = deferred<string>();
  const first = task.run(
    () => failing.promise,
    async () => undefined,
  );
  const second = task.run(
    async () => "second",
    async () => {
      throw new Error("bad scene");
    },
  );
  failing.reject(new Error("404"));
  expect(await first).toBe(false);
  await expect(second).rejects.toThrow("bad scene");
});

it("goes on after a failure", async () => {
  const task = new LatestTask();
  const failed = task.run(
    async () => "first",
    async () => {
      throw new Error("bad scene");
    },
  );
  await expect(failed).rejects.toThrow();
  await expect(
    task.run(
      async () => "second",
      async () => undefined,
    ),
  ).resolves.toBe(true);
});

it("it is running until its end, its failure or its cancellation", async () => {
  const task = new LatestTask();
  const gate = deferred<string>();
  const done = async () => undefined;
  expect(task.isRunning).toBe(false);
  const first = task.run(() => gate.promise, done);
  const second = task.run(() => gate.promise, done);
  expect(task.isRunning).toBe(true);
  gate.resolve("a");
  await Promise.all([first, second]);
  expect(task.isRunning).toBe(false);
  await expect(task.run(() => Promise.reject(new Error("404")), done)).rejects.toThrow();
  expect(task.isRunning).toBe(false);
  void task.run(() => deferred<string>().promise, done);
  task.cancel();
  expect(task.isRunning).toBe(false);
});

it("cancel leaves out what is not committed yet", async () => {
  const task = new LatestTask();
  const done: string[] = [];
  const run = task.run(
    async () => "a",
    async (value) => void done.push(value),
  );
  task.cancel();
  expect(await run).toBe(false);
  expect(done).toEqual([]);
});
