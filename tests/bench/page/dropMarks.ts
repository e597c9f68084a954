// When a drop gets where, seen from outside: the element's events, and calls of the browser's own functions.
import type { RtViewerElement } from "../../../src/element";

/** What takes its time one after the other between a drop and its picture, and the moment that ends each. */
export const DROP_PHASES = {
  /** The file, into memory; and the code that reads files. */
  reading: "read",
  /** From glTF to a scene; and the loader's code. */
  converting: "deviceAsked",
  /** Asking for a GPU. */
  opening: "deviceGiven",
  /** The scene, and its arrays. */
  validating: "geometryAsked",
  /** The boxes of triangles; and the code that sorts them. */
  bounding: "workerAsked",
  startingWorker: "buildAsked",
  building: "built",
  /** The tree and the triangles, as the shader reads them. */
  packing: "compileBegun",
  compiling: "compiled",
  uploading: "uploaded",
  /** Of every pixel, on the canvas. */
  firstSample: "shown",
} as const;

export type DropPhase = keyof typeof DROP_PHASES;
export type DropMark = (typeof DROP_PHASES)[DropPhase];
/** As of `performance.now()`. */
export type DropMarks = Partial<Record<DropMark, number>>;

// The code of `src/compile/geometry.ts`, which is asked for once the scene has been validated.
const GEOMETRY_CODE = /\/geometry-[^/]*\.js$/;

// What is written at once and is more than this, in bytes, is geometry.
const MOST_UNIFORMS = 65536;

/** Follows the first drop onto a viewer that has no scene yet, in a page that has loaded nothing for one. */
export function watchDrop(viewer: RtViewerElement): DropMarks {
  const marks: DropMarks = {};
  const first = (mark: DropMark) => {
    marks[mark] ??= performance.now();
  };
  const lastBefore = (later: DropMark, mark: DropMark) => {
    if (marks[later] === undefined) marks[mark] = performance.now();
  };

  after(Blob.prototype, "arrayBuffer", (read) => void (read as Promise<unknown>).then(() => first("read")));
  before(GPU.prototype, "requestAdapter", () => first("deviceAsked"));
  viewer.addEventListener("loadprogress", ({ detail }) => {
    if (detail.phase === "compiling") first("deviceGiven");
  });
  before(Worker.prototype, "postMessage", () => first("buildAsked"));
  globalThis.Worker = class extends Worker {
    constructor(url: string | URL, options?: WorkerOptions) {
      first("workerAsked");
      super(url, options);
      this.addEventListener("message", ({ data }) => data.type === "built" && first("built"));
    }
  };
  after(GPUDevice.prototype, "createComputePipelineAsync", (made) => {
    void (made as Promise<unknown>).then(() => lastBefore("uploaded", "compiled"));
  });
  const upload = () => lastBefore("shown", "uploaded");
  const mapped = new WeakSet<object>();
  after(GPUDevice.prototype, "createBuffer", (buffer, [descriptor]) => {
    if ((descriptor as GPUBufferDescriptor).mappedAtCreation) mapped.add(buffer as GPUBuffer);
  });
  after(GPUBuffer.prototype, "unmap", (_, __, buffer) => mapped.has(buffer) && upload());
  after(GPUQueue.prototype, "writeTexture", upload);
  after(
    GPUQueue.prototype,
    "writeBuffer",
    (_, args) => (args[2] as ArrayBuffer).byteLength > MOST_UNIFORMS && upload(),
  );
  // While the first program is in use: once the scene rests there is another one.
  const noteCompiled = () => {
    const { tracer } = viewer;
    if (tracer === undefined) requestAnimationFrame(noteCompiled);
    else marks.compileBegun = marks.compiled! - 1000 * tracer.stats.compileSeconds;
  };
  requestAnimationFrame(noteCompiled);
  viewer.addEventListener("ready", () => {
    first("shown");
    const code = performance.getEntriesByType("resource").filter(({ name }) => GEOMETRY_CODE.test(name));
    if (code.length > 0) marks.geometryAsked = Math.min(...code.map(({ startTime }) => startTime));
  });
  return marks;
}

/** @throws {Error} naming a moment that was not seen, or not where it should be. */
export function phasesOf(droppedAt: number, marks: DropMarks): Record<DropPhase, number> {
  let begun = droppedAt;
  const durations = Object.entries(DROP_PHASES).map(([phase, mark]) => {
    const end = marks[mark];
    if (end === undefined || end < begun) throw new Error(`${mark} was seen ${end ?? "never"}, after ${begun}`);
    const milliseconds = end - begun;
    begun = end;
    return [phase, milliseconds];
  });
  return Object.fromEntries(durations);
}

type Methods = Record<string, (...args: unknown[]) => unknown>;

function before(methods: object, name: string, act: () => void): void {
  const original = (methods as Methods)[name]!;
  (methods as Methods)[name] = function (this: object, ...args) {
    act();
    return original.apply(this, args);
  };
}

function after(
  methods: object,
  name: string,
  act: (result: unknown, args: readonly unknown[], target: object) => void,
): void {
  const original = (methods as Methods)[name]!;
  (methods as Methods)[name] = function (this: object, ...args) {
    const result = original.apply(this, args);
    act(result, args, this);
    return result;
  };
}
