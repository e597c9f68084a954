import { afterEach, describe, expect, test, vi } from "vitest";
import { fetchedFile, openedFile } from "../../../src/element/sceneFile";
import type { LoadedScene } from "../../../src/loaders/loadedScene";
import { Packer, TRIANGLE, triangleFile, variantFile } from "../../support/gltf";

const BASE = "http://localhost/";
const { signal } = new AbortController();

afterEach(() => vi.unstubAllGlobals());

/** A server of these files, and what was asked of it. */
function serve(files: Readonly<Record<string, BodyInit>>) {
  const requests: string[] = [];
  const fetch = async (url: string, { signal }: RequestInit = {}) => {
    signal?.throwIfAborted();
    const name = url.slice(BASE.length);
    requests.push(name);
    return name in files ? new Response(files[name]!) : new Response(null, { status: 404 });
  };
  vi.stubGlobal("fetch", vi.fn(fetch));
  return requests;
}

const bytes = (file: Uint8Array) => file as Uint8Array<ArrayBuffer>;
const materialsOf = ({ scene }: LoadedScene) => Object.keys(scene.materials ?? {}).filter((name) => name !== "ground");

describe("a file of several variants", () => {
  test("is fetched once, with what it refers to", async () => {
    const packer = new Packer();
    const attributes = { POSITION: packer.add(TRIANGLE, "VEC3") };
    const mappings = [{ material: 1, variants: [0] }];
    const json = {
      asset: { version: "2.0" },
      extensions: { KHR_materials_variants: { variants: [{ name: "Night" }] } },
      materials: [{ name: "white" }, { name: "black" }],
      meshes: [{ primitives: [{ attributes, material: 0, extensions: { KHR_materials_variants: { mappings } } }] }],
      nodes: [{ mesh: 0 }],
      ...packer.json,
      buffers: [{ uri: "model.bin", byteLength: packer.binary.length }],
    };
    const requests = serve({ "model.gltf": JSON.stringify(json), "model.bin": bytes(packer.binary) });
    const file = fetchedFile("model.gltf", BASE);
    expect(file.variants).toEqual([]);
    expect(materialsOf(await file.read(undefined, signal))).toEqual(["white"]);
    expect(file.variants).toEqual(["Night"]);
    expect(materialsOf(await file.read("Night", signal))).toEqual(["black"]);
    expect(requests).toEqual(["model.gltf", "model.bin"]);
  });

  test("is fetched once, though the first reader gives up", async () => {
    const requests = serve({ "model.glb": bytes(variantFile()) });
    const file = fetchedFile("model.glb", BASE);
    const givenUp = new AbortController();
    const first = file.read("Red", givenUp.signal);
    givenUp.abort();
    expect(materialsOf(await file.read("Blue", signal))).toEqual(["blue"]);
    await expect(first).rejects.toMatchObject({ name: "AbortError" });
    expect(requests).toEqual(["model.glb"]);
  });

  test("shows its default materials for one that it does not have, and says so", async () => {
    serve({ "model.glb": bytes(variantFile()) });
    const file = fetchedFile("model.glb", BASE);
    expect([file.shownFor("Moon"), file.warningFor("Moon")]).toEqual(["Moon", undefined]); // nobody knows yet
    const { warnings } = await file.read("Moon", signal);
    expect(file.shownFor("Moon")).toBeUndefined();
    expect(file.warningFor("Moon")).toBe('The file has no variant "Moon": it has "Red", "Blue"');
    expect(warnings).toEqual([file.warningFor("Moon")]);
    expect([file.shownFor("Red"), file.warningFor("Red")]).toEqual(["Red", undefined]);
    expect([file.shownFor(undefined), file.warningFor(undefined)]).toEqual([undefined, undefined]);
  });

  test("is read again from the files that were opened", async () => {
    const file = openedFile([new Blob([bytes(variantFile())])]);
    expect(materialsOf(await file.read("Red", signal))).toEqual(["red"]);
    expect(materialsOf(await file.read("Blue", signal))).toEqual(["blue"]);
    expect(file.variants).toEqual(["Red", "Blue"]);
  });
});

test("a download that failed is tried again", async () => {
  const files: Record<string, BodyInit> = {};
  const requests = serve(files);
  const file = fetchedFile("model.glb", BASE);
  await expect(file.read(undefined, signal)).rejects.toThrow(`${BASE}model.glb could not be fetched: 404`);
  files["model.glb"] = bytes(triangleFile());
  expect(materialsOf(await file.read(undefined, signal))).toEqual(["default"]);
  expect(requests).toEqual(["model.glb", "model.glb"]);
});

test("a file that is closed is downloaded no further", async () => {
  const stop = vi.fn();
  vi.stubGlobal("fetch", (_: string, init: RequestInit) => {
    return new Promise((_, reject) => {
      init.signal!.addEventListener("abort", () => {
        stop();
        reject(init.signal!.reason);
      });
    });
  });
  const file = fetchedFile("model.glb", BASE);
  const reading = file.read(undefined, signal);
  file.close();
  await expect(reading).rejects.toMatchObject({ name: "AbortError" });
  expect(stop).toHaveBeenCalledOnce();
});

test("what is no URL is refused", async () => {
  await expect(fetchedFile("http://[", BASE).read(undefined, signal)).rejects.toThrow("http://[ is not a URL");
});
