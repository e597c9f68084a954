// The Basis Universal transcoder as three.js ships it, which has Zstandard within. THIRD_PARTY_LICENSES.md has the licences of both.

import wasm from "three/examples/jsm/libs/basis/basis_transcoder.wasm?url&inline";
import { inlinedBytes } from "../inlinedBytes";

let compiling: Promise<WebAssembly.Module> | undefined;

/** Compiled once. @throws where WebAssembly is not allowed. */
export function compileTranscoder(): Promise<WebAssembly.Module> {
  compiling ??= inlinedBytes(wasm).then((bytes) => WebAssembly.compile(bytes));
  return compiling;
}
