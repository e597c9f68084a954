// Runs Binomial's transcoder in place of the script that comes with it. That one makes functions out of text, which a content
// security policy forbids, and looks for Node's modules, which bundlers then do too.
//
// The transcoder was compiled with Emscripten's embind. When it starts, it names its functions and classes, and where they are
// in its table. When it is called, it reads and writes JavaScript's values by handles, "emval". This is as much of it as classes
// need whose arguments are numbers and byte arrays.

import { RtViewerError } from "../../errors";

/** What the module calls these functions of Emscripten. It is compiled so; a test compares the list with the script. */
export const IMPORT_NAMES = {
  a: "_embind_register_enum_value",
  b: "_emval_decref",
  c: "_embind_register_value_object_field",
  d: "_embind_register_class_function",
  e: "_emval_run_destructors",
  f: "_embind_register_memory_view",
  g: "_emval_get_property",
  h: "_emval_new_cstring",
  i: "_embind_register_function",
  j: "_emval_get_method_caller",
  k: "_emval_incref",
  l: "_embind_register_integer",
  m: "_embind_register_constant",
  n: "_emval_as",
  o: "_embind_register_enum",
  p: "_emval_call_method",
  q: "_emval_call",
  r: "_emval_get_module_property",
  s: "_embind_finalize_value_object",
  t: "_embind_register_value_object",
  u: "_embind_register_std_wstring",
  v: "_embind_register_class_constructor",
  w: "_embind_register_class",
  x: "_emval_get_global",
  y: "fd_write",
  z: "_embind_register_std_string",
  A: "_embind_register_float",
  B: "fd_seek",
  C: "_embind_register_bigint",
  D: "emscripten_resize_heap",
  E: "fd_close",
  F: "_emscripten_memcpy_js",
  G: "_abort_js",
  H: "_embind_register_emval",
  I: "_embind_register_bool",
  J: "_embind_register_void",
  K: "__cxa_throw",
} as const;

type Exports = {
  readonly L: WebAssembly.Memory;
  /** Runs what C++ runs before main. */
  readonly M: () => void;
  readonly P: WebAssembly.Table;
};
type Name = (typeof IMPORT_NAMES)[keyof typeof IMPORT_NAMES];
type Import = (...args: number[]) => number | undefined | boolean;
type Caller = { readonly result: number; readonly args: readonly number[]; readonly isConstructor: boolean };

export type TranscoderHost = {
  /** Calls a function by its name: `Class` makes an object, `Class.method` and `~Class` take it first. An object is a number. */
  readonly call: (name: string, ...args: number[]) => number;
  /** Gives values numbers that functions take, as long as `use` runs. */
  readonly withValues: (values: readonly object[], use: (...handles: number[]) => void) => void;
};

/** As much as addresses reach that come as signed numbers. */
const MAX_MEMORY_BYTES = 2 ** 31;
const PAGE_BYTES = 2 ** 16;
/** Each argument of a call takes as much. */
const ARGUMENT_BYTES = 8;
const ERRNO_NOSYS = 52;
/** Handles of values that every program has. */
const CONSTANTS = new Map<unknown, number>([
  [undefined, 2],
  [null, 4],
  [true, 6],
  [false, 8],
]);

/** @throws what WebAssembly does, where it is forbidden or finds no memory. */
export async function startHost(module: WebAssembly.Module): Promise<TranscoderHost> {
  const functions = new Map<string, (...args: number[]) => number>();
  /** By the number of the type. */
  const classes = new Map<number, string>();
  const emvalTypes = new Set<number>();
  const callers: Caller[] = [];
  const values: unknown[] = [];
  for (const [value, handle] of CONSTANTS) values[handle] = value;

  const bytes = () => new Uint8Array(exports.L.buffer);
  const words = () => new Uint32Array(exports.L.buffer);
  const text = (start: number) => String.fromCharCode(...bytes().subarray(start, bytes().indexOf(0, start)));
  const handle = (value: unknown) => CONSTANTS.get(value) ?? values.push(value) - 1;
  // biome-ignore lint/suspicious/noExplicitAny: they can be anything
  const value = (handle: number): any => values[handle];
  const bind = (name: string, invoker: number, ...first: number[]) =>
    functions.set(name, (...args) => exports.P.get(invoker)(...first, ...args));
  const argumentsOf = ({ args }: Caller, start: number) =>
    args.map((type, i) => {
      const word = words()[(start + ARGUMENT_BYTES * i) / 4]!;
      return emvalTypes.has(type) ? value(word) : word;
    });
  const resultOf = ({ result }: Caller, what: unknown) => (emvalTypes.has(result) ? handle(what) : Number(what));

  const implemented: Partial<Record<Name, Import>> = {
    _embind_register_class: (...args) => {
      const [type, name, destroy] = [args[0]!, text(args[10]!), args[12]!];
      classes.set(type, name);
      bind(`~${name}`, destroy);
      return undefined;
    },
    _embind_register_class_constructor: (type, _count, _types, _signature, invoker, make) =>
      void bind(classes.get(type!)!, invoker!, make!),
    _embind_register_class_function: (type, name, _count, _types, _signature, invoker, method) =>
      void bind(`${classes.get(type!)}.${text(name!)}`, invoker!, method!),
    _embind_register_function: (name, _count, _types, _signature, invoker, target) =>
      void bind(text(name!), invoker!, target!),
    _embind_register_emval: (type) => void emvalTypes.add(type!),

    _emval_new_cstring: (name) => handle(text(name!)),
    _emval_get_global: (name) => handle(text(name!) === "Uint8Array" ? Uint8Array : undefined),
    _emval_get_module_property: (name) => handle(text(name!) === "HEAP8" ? bytes() : undefined),
    _emval_get_property: (object, key) => handle(value(object!)[value(key!)]),
    _emval_as: (object) => Number(value(object!)),
    _emval_get_method_caller: (count, types, kind) => {
      const [result, ...args] = words().subarray(types! / 4, types! / 4 + count!);
      return callers.push({ result: result!, args, isConstructor: kind === 1 }) - 1;
    },
    _emval_call: (caller, target, _destructors, args) => {
      const found = callers[caller!]!;
      const [called, given] = [value(target!), argumentsOf(found, args!)];
      return resultOf(found, found.isConstructor ? new called(...given) : called(...given));
    },
    _emval_call_method: (caller, object, name, _destructors, args) => {
      const found = callers[caller!]!;
      return resultOf(found, value(object!)[text(name!)](...argumentsOf(found, args!)));
    },

    _emscripten_memcpy_js: (to, from, count) => void bytes().copyWithin(to!, from!, from! + count!),
    emscripten_resize_heap: (byteCount) => grow(exports.L, byteCount! >>> 0),
    fd_write: () => ERRNO_NOSYS,
    fd_seek: () => ERRNO_NOSYS,
    fd_close: () => ERRNO_NOSYS,
    _abort_js: () => fail(),
    __cxa_throw: () => fail(),
  };
  const none: Import = () => undefined;
  const imports = Object.entries(IMPORT_NAMES).map(([letter, name]) => [letter, implemented[name] ?? none]);
  const instance = await WebAssembly.instantiate(module, { a: Object.fromEntries(imports) });
  const exports = instance.exports as unknown as Exports;
  exports.M();
  const valueCount = values.length;
  return {
    withValues: (given, use) => {
      use(...given.map(handle));
      values.length = valueCount;
    },
    call: (name, ...args) => {
      const found = functions.get(name);
      if (found === undefined) throw new RtViewerError(`the transcoder has no ${name}`);
      return found(...args);
    },
  };
}

function grow(memory: WebAssembly.Memory, byteCount: number): boolean {
  const hasBytes = memory.buffer.byteLength;
  if (byteCount > MAX_MEMORY_BYTES) return false;
  // A fifth more than before, so that it does not grow each time by a little.
  const wanted = Math.min(MAX_MEMORY_BYTES, Math.max(byteCount, 1.2 * hasBytes));
  try {
    memory.grow(Math.ceil((wanted - hasBytes) / PAGE_BYTES));
    return true;
  } catch {
    return false;
  }
}

function fail(): never {
  throw new RtViewerError("its data is damaged, or takes too much memory");
}
