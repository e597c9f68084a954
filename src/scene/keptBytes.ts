// Bytes that nobody changes any more, so that they need not be copied: the texels of a picture can be a quarter of a gigabyte.

// Of the whole realm, because the loader of glTF may come in a bundle of its own.
const KEPT = Symbol.for("rt-viewer: kept");

/** Says that nobody will change these bytes any more. */
export function keep<T extends Uint8Array>(bytes: T): T {
  return Object.defineProperty(bytes, KEPT, { value: true });
}

/** Whether somebody said so. Whatever is in bytes is valid, so everybody's word will do. */
export function isKept(bytes: object): boolean {
  return Object.hasOwn(bytes, KEPT);
}
