import { RtViewerError } from "../errors";
import { fetchBytes, nameOf } from "../loaders/fetchBytes";
import type { LoadedScene } from "../loaders/loadedScene";
import { missingVariant } from "../loaders/missingVariant";

/** How a file is read, as often as another variant is wanted, and how it is given up. */
type FileSource = {
  readonly read: (variant: string | undefined, signal: AbortSignal) => Promise<LoadedScene>;
  readonly close: () => void;
};

/**
 * A scene file whose variants are shown one after the other. It is fetched once. While it is open, its bytes are kept if it has
 * variants, and what is made of them is not: decoded pictures can take ten times the memory of the file.
 */
export class SceneFile {
  readonly #source: FileSource;
  #variants: readonly string[] | undefined;

  constructor(source: FileSource) {
    this.#source = source;
  }

  /** Names, in the order of the file; empty until it has been read. */
  get variants(): readonly string[] {
    return this.#variants ?? [];
  }

  /** Which variant is shown when this one is wanted: `undefined`, the default materials, for one that it is known not to have. */
  shownFor(wanted: string | undefined): string | undefined {
    return this.warningFor(wanted) === undefined ? wanted : undefined;
  }

  /** What is to be said of a variant that it is known not to have. */
  warningFor(wanted: string | undefined): string | undefined {
    if (wanted === undefined || this.#variants === undefined || this.#variants.includes(wanted)) return undefined;
    return missingVariant("The file", wanted, this.#variants);
  }

  /** @throws {RtViewerError} if it cannot be fetched or read. After an abort, the signal's reason. */
  async read(variant: string | undefined, signal: AbortSignal): Promise<LoadedScene> {
    const loaded = await this.#source.read(variant, signal);
    this.#variants = loaded.variants;
    if (loaded.variants.length === 0) this.close(); // there will be nothing else to read
    return loaded;
  }

  /** Ends the download and lets go of the bytes. */
  close(): void {
    this.#source.close();
  }
}

/**
 * A file of any kind that `loadScene` knows, with what it refers to. What is in a JSON scene is not validated here: the tracer
 * does that, and lists the issues.
 *
 * @param src - relative to `base`. What the file refers to is relative to the file.
 */
export function fetchedFile(src: string, base: string): SceneFile {
  const download = new AbortController();
  const files = new Map<string, Promise<Uint8Array>>();
  // Whoever reads may give up and another one go on, so the downloads are not the readers'.
  const fetchOnce = (url: string): Promise<Uint8Array> => {
    const known = files.get(url);
    if (known !== undefined) return known;
    const bytes = fetchBytes(url, download.signal);
    files.set(url, bytes);
    bytes.catch(() => files.delete(url)); // the next reader tries again
    return bytes;
  };
  return new SceneFile({
    async read(variant, signal) {
      if (!URL.canParse(src, base)) throw new RtViewerError(`${nameOf(src)} is not a URL`);
      const url = new URL(src, base).href;
      // The code that tells files apart arrives while the file does.
      const [bytes, { loadScene }] = await Promise.all([fetchOnce(url), import("../loaders/loadScene")]);
      const options = { name: nameOf(url), baseUrl: url, signal, fetchResource: fetchOnce };
      return loadScene(bytes, { ...options, ...(variant !== undefined && { variant }) });
    },
    close() {
      download.abort();
      files.clear();
    },
  });
}

/** Files that were dropped or picked together. The browser keeps them. */
export function openedFile(files: readonly Blob[]): SceneFile {
  return new SceneFile({
    async read(variant, signal) {
      const { readFiles } = await import("../loaders/readFiles");
      return readFiles(files, signal, variant);
    },
    close() {},
  });
}
