import { afterEach, describe, expect, test, vi } from "vitest";
import { fetchBytes } from "../../../src/loaders/fetchBytes";
import { readFiles } from "../../../src/loaders/readFiles";

const LIMIT = 2 ** 29;
const answer = (body: BodyInit | null, init?: ResponseInit) =>
  vi.stubGlobal("fetch", async () => new Response(body, init));

/** A body of this many MiB, of which no more is made than is asked for. */
function endless(mebibytes: number) {
  const chunk = new Uint8Array(2 ** 20);
  let sent = 0;
  const end = vi.fn();
  const body = new ReadableStream({
    pull(controller) {
      if (sent++ < mebibytes) controller.enqueue(chunk);
      else controller.close();
    },
    cancel: end,
  });
  return { body, end, sent: () => sent };
}

afterEach(() => void vi.unstubAllGlobals());

test("a file is downloaded", async () => {
  answer("abc");
  expect([...(await fetchBytes("a.bin"))]).toEqual([97, 98, 99]);
  answer(null);
  expect(await fetchBytes("a.bin")).toHaveLength(0);
});

describe("a file that is too large", () => {
  const tooLarge = { name: "LoadError", message: `a.glb has more than ${LIMIT} bytes` };

  test("by what its server says is not downloaded", async () => {
    const { body, end, sent } = endless(1e6);
    answer(body, { headers: { "content-length": String(LIMIT + 1) } });
    await expect(fetchBytes("a.glb")).rejects.toMatchObject(tooLarge);
    expect(sent()).toBeLessThan(10);
    expect(end).toHaveBeenCalled();
  });

  test("whatever its server says, is downloaded as far as the limit", async () => {
    const { body, end, sent } = endless(1e6);
    answer(body, { headers: { "content-length": "3" } });
    await expect(fetchBytes("a.glb")).rejects.toMatchObject(tooLarge);
    expect(sent()).toBeLessThan(LIMIT / 2 ** 20 + 10);
    await vi.waitFor(() => expect(end).toHaveBeenCalled());
  });

  test("is not read when it is dropped", async () => {
    const file = new File(["{}"], "big.json");
    Object.defineProperty(file, "size", { value: LIMIT + 1 });
    await expect(readFiles([file], new AbortController().signal)).rejects.toMatchObject({
      name: "LoadError",
      message: expect.stringContaining(`has more than ${LIMIT} bytes`),
    });
  });
});

test("what fails says why, with as much of its address as can be read", async () => {
  answer("", { status: 404, statusText: "Not Found" });
  await expect(fetchBytes("a.bin")).rejects.toThrow("a.bin could not be fetched: 404 Not Found");
  const long = await fetchBytes(`data:,${"x".repeat(1e6)}`).catch(String);
  expect(long).toHaveLength("RtViewerError: … could not be fetched: 404 Not Found".length + 200);
});

test("an aborted download throws the reason", async () => {
  const reason = new Error("no longer needed");
  vi.stubGlobal("fetch", () => Promise.reject(new Error("aborted")));
  await expect(fetchBytes("a.bin", AbortSignal.abort(reason))).rejects.toBe(reason);
});
