// Runs functions of the shader modules on the CPU, with every freedom that WGSL leaves to a device. It reads what straight-line
// functions of f32, u32 and bool are made of: let, var, if, return, vectors, structs.

import { link, parseModule } from "../../../src/compile/link";
import { SHADER_MODULES } from "../shaderModules";
import { type Choices, negated, nextAbove, Product, round, type Scalar, sum, value } from "./choices";

/** f32 as numbers, u32 as bigints, vectors as arrays, structs by their fields. */
export type Value = Scalar | bigint | boolean | readonly Value[] | { readonly [field: string]: Value };
export type Run = (name: string, ...args: readonly Value[]) => Value;

/**
 * @param modules - names of shader modules, or WGSL text.
 * @returns what calls their functions, making the given choices.
 */
export function wgslFunctions(modules: readonly string[]): (choices: Choices) => Run {
  // Of what is under conditions, that of a scene that needs nothing.
  const text = modules.map((module) => linkAlone(SHADER_MODULES[module] ?? module)).join("\n");
  const parser = new Parser(text.replace(/\/\/.*/g, ""));
  const program = new Function("R", parser.program()) as (
    runtime: Runtime,
  ) => Record<string, (...args: Value[]) => Value>;
  return (choices) => {
    const runtime = new Runtime(choices);
    const functions = program(runtime);
    return (name, ...args) => runtime.settled(functions[name]!(...args));
  };
}

const TOKEN =
  /\s*(0x[\da-f.]+p[+-]?\d+|0x[\da-f]+u?|\d[\d.]*(?:e[+-]?\d+)?[uif]?|\w+|<<|[<>=!]=|->|&&|\|\||[-+*/]=|[^\s])/giy;

function linkAlone(text: string): string {
  const module = parseModule(text);
  return link((path) => (path === "it" ? module : undefined), "it", {});
}

/** Translates WGSL to JavaScript in which every operation is a call of the runtime. */
class Parser {
  readonly #tokens: string[] = [];
  #at = 0;

  constructor(text: string) {
    for (TOKEN.lastIndex = 0; ; ) {
      const match = TOKEN.exec(text);
      if (!match) break;
      this.#tokens.push(match[1]!);
    }
  }

  program(): string {
    const parts: string[] = [];
    const names: string[] = [];
    while (this.#at < this.#tokens.length) {
      const token = this.#next();
      if (token === "fn") {
        const name = this.#next();
        names.push(name);
        parts.push(this.#function(name));
      } else if (token === "struct") {
        const name = this.#next();
        parts.push(
          `function ${name}(...v) { const names = ${JSON.stringify(this.#fields())}; return R.struct(names, v); }`,
        );
      } else if (token === "const") {
        const name = this.#next();
        this.#expect("=");
        parts.push(`const ${name} = ${this.#expression()};`);
        this.#expect(";");
      } else this.#skip(token);
    }
    return `${parts.join("\n")}\nreturn { ${names.join(", ")} };`;
  }

  get #peek(): string | undefined {
    return this.#tokens[this.#at];
  }

  #next(): string {
    return this.#tokens[this.#at++]!;
  }

  #take(token: string): boolean {
    if (this.#peek !== token) return false;
    this.#at++;
    return true;
  }

  #expect(token: string): void {
    const found = this.#next();
    if (found !== token) {
      const before = this.#tokens.slice(Math.max(this.#at - 12, 0), this.#at).join(" ");
      throw new SyntaxError(`expected ${token}, got ${found} after ${before}`);
    }
  }

  /** What is no declaration of a function, struct or constant. */
  #skip(token: string): void {
    if (token === "import" || token === "var") while (this.#next() !== ";");
    if (token === "@") {
      this.#next();
      if (this.#take("(")) for (let depth = 1; depth > 0; ) depth += DEPTH[this.#next()] ?? 0;
    }
  }

  #fields(): string[] {
    this.#expect("{");
    const names: string[] = [];
    while (!this.#take("}")) {
      names.push(this.#next());
      this.#expect(":");
      this.#type();
      this.#take(",");
    }
    return names;
  }

  #type(): void {
    this.#next();
    if (this.#take("<")) while (!this.#take(">")) this.#next();
  }

  #function(name: string): string {
    this.#expect("(");
    const parameters: string[] = [];
    while (!this.#take(")")) {
      parameters.push(this.#next());
      this.#expect(":");
      this.#type();
      this.#take(",");
    }
    if (this.#take("->")) this.#type();
    return `function ${name}(${parameters.join(", ")}) ${this.#block()}`;
  }

  #block(): string {
    this.#expect("{");
    let text = "{";
    while (!this.#take("}")) text += this.#statement();
    return `${text}}`;
  }

  #statement(): string {
    if (this.#take("return")) {
      const result = this.#expression();
      this.#expect(";");
      return `return ${result};`;
    }
    if (this.#take("if")) return `if (${this.#expression()}) ${this.#block()}`;
    if (this.#peek === "let" || this.#peek === "var") {
      this.#next();
      const name = this.#next();
      this.#expect("=");
      const initial = this.#expression();
      this.#expect(";");
      return `let ${name} = ${initial};`;
    }
    const name = this.#next();
    const operator = this.#next();
    const right = this.#expression();
    this.#expect(";");
    return `${name} = ${operator === "=" ? right : `R.${BINARY[operator[0]!]!.call}(${name}, ${right})`};`;
  }

  #expression(least = 0): string {
    let left = this.#unary();
    for (;;) {
      const operator = BINARY[this.#peek ?? ""];
      if (!operator || operator.level < least) return left;
      this.#next();
      left = `R.${operator.call}(${left}, ${this.#expression(operator.level + 1)})`;
    }
  }

  #unary(): string {
    if (this.#take("-")) return `R.minus(${this.#unary()})`;
    if (this.#take("!")) return `R.not(${this.#unary()})`;
    return this.#postfix(this.#primary());
  }

  #primary(): string {
    if (this.#take("(")) {
      const inner = this.#expression();
      this.#expect(")");
      return inner;
    }
    const token = this.#next();
    if (/^[\d]/.test(token)) return literal(token);
    if (token === "true" || token === "false") return token;
    let type = token;
    if (token === "vec3" || token === "vec2" || token === "bitcast") {
      this.#expect("<");
      type += `_${this.#next()}`;
      this.#expect(">");
    }
    if (!this.#take("(")) return token;
    const args: string[] = [];
    while (!this.#take(")")) {
      args.push(this.#expression());
      this.#take(",");
    }
    return type in BUILTINS ? `R.${type}(${args.join(", ")})` : `${type}(${args.join(", ")})`;
  }

  #postfix(primary: string): string {
    let text = primary;
    while (this.#take(".")) text = `R.member(${text}, "${this.#next()}")`;
    return text;
  }
}

const DEPTH: Readonly<Record<string, number>> = { "(": 1, ")": -1 };

const BINARY: Readonly<Record<string, { readonly call: string; readonly level: number }>> = {
  "||": { call: "or", level: 1 },
  "&&": { call: "and", level: 2 },
  "|": { call: "or", level: 3 },
  "&": { call: "and", level: 4 },
  "==": { call: "equal", level: 5 },
  "!=": { call: "differ", level: 5 },
  "<": { call: "below", level: 6 },
  "<=": { call: "notAbove", level: 6 },
  ">": { call: "above", level: 6 },
  ">=": { call: "notBelow", level: 6 },
  "<<": { call: "shifted", level: 7 },
  "+": { call: "plus", level: 7 },
  "-": { call: "less", level: 7 },
  "*": { call: "times", level: 8 },
  "/": { call: "over", level: 8 },
};

function literal(token: string): string {
  if (token.endsWith("u")) return `${token.slice(0, -1)}n`;
  const hex = /^0x([\da-f]+)\.?([\da-f]*)p([+-]?\d+)$/i.exec(token);
  if (!hex) return String(Math.fround(Number(token.replace(/f$/, ""))));
  const [, whole, fraction, exponent] = hex;
  return String(Number.parseInt(whole! + fraction!, 16) * 2 ** (Number(exponent) - 4 * fraction!.length));
}

type Vector = readonly Value[];

/** The operations of WGSL, by the names that the translated program calls. */
class Runtime {
  readonly #choices: Choices;

  constructor(choices: Choices) {
    this.#choices = choices;
  }

  /** With all products rounded. */
  settled(x: Value): Value {
    if (x instanceof Product) return x.rounded(this.#choices);
    if (Array.isArray(x)) return x.map((each) => this.settled(each));
    return x;
  }

  struct(names: readonly string[], values: readonly Value[]): Value {
    return Object.fromEntries(names.map((name, i) => [name, values[i]!]));
  }

  member(x: Value, name: string): Value {
    if (!Array.isArray(x)) return (x as Readonly<Record<string, Value>>)[name]!;
    const components = [...name].map(
      (letter) => x["xyzw".includes(letter) ? "xyzw".indexOf(letter) : "rgba".indexOf(letter)]!,
    );
    return components.length === 1 ? components[0]! : components;
  }

  // Operators, on scalars and component by component.

  plus = this.#each((x, y) => (typeof x === "bigint" ? wrapped(x + (y as bigint)) : this.#sum(x, y)));
  less = this.#each((x, y) =>
    typeof x === "bigint" ? wrapped(x - (y as bigint)) : this.#sum(x, negated(y as Scalar)),
  );
  times = this.#each((x, y) => {
    if (typeof x === "bigint") return wrapped(x * (y as bigint));
    return new Product(this.#f32(x) * this.#f32(y));
  });
  /** 2.5 ULP. */
  over = this.#each((x, y) => this.#near(this.#f32(x) / this.#f32(y)));
  below = this.#each((x, y) => this.#f32(x) < this.#f32(y));
  above = this.#each((x, y) => this.#f32(x) > this.#f32(y));
  notAbove = this.#each((x, y) => this.#f32(x) <= this.#f32(y));
  notBelow = this.#each((x, y) => this.#f32(x) >= this.#f32(y));
  equal = this.#each((x, y) => this.#plain(x) === this.#plain(y));
  differ = this.#each((x, y) => this.#plain(x) !== this.#plain(y));
  and = this.#each((x, y) => (typeof x === "bigint" ? x & (y as bigint) : (x as boolean) && (y as boolean)));
  or = this.#each((x, y) => (typeof x === "bigint" ? x | (y as bigint) : (x as boolean) || (y as boolean)));
  max = this.#each((x, y) =>
    typeof x === "bigint" ? (x > (y as bigint) ? x : y) : Math.max(this.#f32(x), this.#f32(y)),
  );
  shifted = this.#each((x, y) => wrapped((x as bigint) << (y as bigint)));
  min = this.#each((x, y) =>
    typeof x === "bigint" ? (x < (y as bigint) ? x : y) : Math.min(this.#f32(x), this.#f32(y)),
  );
  not = this.#map((x) => !x);
  minus = this.#map((x) => negated(x as Scalar));
  abs = this.#map((x) => (x instanceof Product ? new Product(Math.abs(x.exact)) : Math.abs(x as number)));
  sign = this.#map((x) => Math.sign(this.#f32(x)));
  floor = this.#map((x) => Math.floor(this.#f32(x)));
  sqrt = this.#map((x) => this.#near(Math.sqrt(this.#f32(x))));

  select(otherwise: Value, chosen: Value, condition: Value): Value {
    if (!Array.isArray(condition)) return condition ? chosen : otherwise;
    return condition.map((each, i) => (each ? (chosen as Vector)[i]! : (otherwise as Vector)[i]!));
  }

  all(x: Vector): boolean {
    return x.every(Boolean);
  }

  any(x: Vector): boolean {
    return x.some(Boolean);
  }

  dot(a: Vector, b: Vector): Value {
    const products = a.map((x, i) => this.times(x, b[i]!));
    return products.reduce((total, product) => this.plus(total, product));
  }

  cross(a: Vector, b: Vector): Value {
    return [0, 1, 2].map((i) => {
      const [j, k] = [(i + 1) % 3, (i + 2) % 3];
      return this.less(this.times(a[j]!, b[k]!), this.times(a[k]!, b[j]!));
    });
  }

  length(a: Vector): Value {
    return this.sqrt(this.dot(a, a));
  }

  normalize(a: Vector): Value {
    return this.over(a, this.length(a));
  }

  vec2f(...parts: readonly Value[]): Value {
    return vector(2, parts);
  }

  vec3f(...parts: readonly Value[]): Value {
    return vector(3, parts);
  }

  vec4f(...parts: readonly Value[]): Value {
    return vector(4, parts);
  }

  vec2u(...parts: readonly Value[]): Value {
    return vector(2, parts);
  }

  vec3u(...parts: readonly Value[]): Value {
    return vector(3, parts);
  }

  vec3_bool(...parts: readonly Value[]): Value {
    return vector(3, parts);
  }

  bitcast_vec3u(x: Vector): Value {
    return x.map((each) => BigInt(bitsOf(this.#f32(each))));
  }

  bitcast_vec3f(x: Vector): Value {
    return x.map((each) => floatOf(Number(each)));
  }

  unpack2x16unorm(x: bigint): Value {
    return [x & 0xffffn, x >> 16n].map((share) => Math.fround(Number(share) / 65535));
  }

  pack2x16unorm(x: Vector): Value {
    const [low, high] = x.map((share) => BigInt(Math.floor(0.5 + 65535 * Math.min(Math.max(this.#f32(share), 0), 1))));
    return low! | (high! << 16n);
  }

  #f32(x: Value): number {
    return value(x as Scalar, this.#choices);
  }

  #plain(x: Value): Value {
    return x instanceof Product ? x.rounded(this.#choices) : x;
  }

  #sum(x: Value, y: Value): number {
    return sum(x as Scalar, y as Scalar, this.#choices);
  }

  /** A value that a device may miss by two ULP. */
  #near(x: number): number {
    const direction = this.#choices.round();
    const rounded = round(x, 0, direction);
    if (direction === 0 || rounded === 0 || !Number.isFinite(rounded)) return rounded;
    return direction > 0 ? nextAbove(rounded) : -nextAbove(-rounded);
  }

  #each(operation: (x: Value, y: Value) => Value): (x: Value, y: Value) => Value {
    return (x, y) => {
      if (Array.isArray(x)) return x.map((each, i) => operation(each, Array.isArray(y) ? y[i] : y));
      return Array.isArray(y) ? y.map((each) => operation(x, each)) : operation(x, y);
    };
  }

  #map(operation: (x: Value) => Value): (x: Value) => Value {
    return (x) => (Array.isArray(x) ? x.map(operation) : operation(x));
  }
}

const BUILTINS = new Runtime({ fuse: () => 0, round: () => 0 });

function vector(size: number, parts: readonly Value[]): Value {
  const components = parts.flatMap((part) => (Array.isArray(part) ? part : [part])) as Value[];
  return components.length === 1 ? Array.from({ length: size }, () => components[0]!) : components;
}

function wrapped(x: bigint): bigint {
  return BigInt.asUintN(32, x);
}

const float = new Float32Array(1);
const word = new Uint32Array(float.buffer);

function bitsOf(x: number): number {
  float[0] = x;
  return word[0]!;
}

function floatOf(x: number): number {
  word[0] = x;
  return float[0]!;
}
