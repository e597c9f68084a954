// Links shader modules written in WESL, WGSL with imports and conditions (https://wesl-lang.dev): the part of it that ours use.
//
//     import package::ray::{Hit, Ray};        a declaration of another module, by its name
//     package::shapes::box::boxIntersect      the same by its full name
//     @if(MESHES && !SMOOTH)                  before a declaration, a member of a struct, a statement or a block
//
// wesl-js does all of WESL. It would be more than a quarter of what a page downloads, and takes three times as long. The
// tests have it: this has to link what it links.

export type Conditions = Readonly<Record<string, boolean>>;

type Condition = readonly string[];
/** A token, or some of them under a condition. */
type Part = string | { readonly condition: Condition; readonly parts: readonly Part[] };

type Declaration = {
  readonly name: string;
  readonly condition: Condition;
  readonly parts: readonly Part[];
  readonly module: ShaderModule;
};

/** A module taken apart. */
export type ShaderModule = {
  /** By the name it has here, the module and the name there. */
  readonly imports: ReadonlyMap<string, readonly [path: string, name: string]>;
  /** By name; several under one name exclude each other. */
  readonly declarations: ReadonlyMap<string, readonly Declaration[]>;
};

/**
 * All declarations of a module, and those of others that they make use of.
 *
 * @param moduleAt - by its path, `shapes/box` say. Without one, names of its declarations are left as they are.
 */
export function link(
  moduleAt: (path: string) => ShaderModule | undefined,
  root: string,
  conditions: Conditions,
): string {
  const names = new Map<Declaration, string>();
  const taken = new Set<string>();
  const declare = (declaration: Declaration) => {
    const known = names.get(declaration);
    if (known !== undefined) return known;
    let name = declaration.name;
    for (let i = 0; taken.has(name); i++) name = `${declaration.name}${i}`;
    taken.add(name);
    names.set(declaration, name);
    return name;
  };
  const find = (module: ShaderModule | undefined, name: string) =>
    module?.declarations.get(name)?.find(({ condition }) => holds(condition, conditions));

  const start = moduleAt(root);
  for (const name of start?.declarations.keys() ?? []) {
    const found = find(start, name);
    if (found) declare(found);
  }
  const texts: string[] = [];
  // Grows while it is gone through.
  for (const { parts, module } of names.keys()) {
    const tokens = select(parts, conditions);
    const resolved = (name: string, path?: string) => {
      const [from, there] = path === undefined ? (module.imports.get(name) ?? [undefined, name]) : [path, name];
      const found = find(from === undefined ? module : moduleAt(from), there);
      return found ? declare(found) : name;
    };
    let text = "";
    for (let i = 0; i < tokens.length; i++) {
      const token = tokens[i]!;
      if (token === "package" && tokens[i + 1] === "::") {
        const path: string[] = [];
        for (; tokens[i + 1] === "::"; i += 2) path.push(tokens[i + 2]!);
        const name = path.pop()!;
        text += resolved(name, path.join("/"));
      } else text += isReference(tokens, i) ? resolved(token) : token;
    }
    texts.push(text.trim());
  }
  return `${texts.join("\n\n")}\n`;
}

const TOKEN = /\s+|\/\/.*|\/\*[\s\S]*?\*\/|[\p{L}_][\p{L}\d_]*|\d\w*|::|&&|\|\||[\s\S]/gu;
const WORD = /^[\p{L}_]/u;
const BLANK = /^(\s|\/[/*])/;
const DECLARATION = /^(fn|struct|const|var|alias|override)$/;

/** Whether a token can name a declaration: no member, no attribute, and nothing that is declared here. */
function isReference(tokens: readonly string[], i: number): boolean {
  const before = tokens[i - 1];
  if (!WORD.test(tokens[i]!) || before === "." || before === "@") return false;
  return tokens[i + 1] !== ":" || tokens[i - 2] === "case";
}

/** Takes a module apart, whatever the conditions. */
export function parseModule(text: string): ShaderModule {
  const imports = new Map<string, readonly [string, string]>();
  const declarations = new Map<string, Declaration[]>();
  const module = { imports, declarations };
  const parser = new Parser(text.match(TOKEN) ?? []);
  for (;;) {
    const comment = parser.blank();
    if (parser.isAtEnd) return module;
    const imported = parser.imports();
    if (imported !== undefined) {
      const [, path, list] = /^import package::(.*)::(\{.*\}|\w+)$/s.exec(imported)!;
      for (const name of list!.match(/\w+/g)!) imports.set(name, [path!.replaceAll("::", "/"), name]);
      continue;
    }
    const statement = parser.statement(false);
    const words = flat(statement);
    const keyword = words.findIndex((word) => DECLARATION.test(word));
    let at = keyword + 1;
    if (words[at] === "<") at = words.indexOf(">", at) + 1; // of var<storage, read>
    while (BLANK.test(words[at]!)) at++;
    const name = words[at]!;
    const [first] = statement;
    const { condition, parts } = typeof first === "object" ? first : { condition: [], parts: statement };
    const declaration = { name, condition, parts: [...comment, ...parts], module };
    declarations.set(name, [...(declarations.get(name) ?? []), declaration]);
  }
}

class Parser {
  readonly #tokens: readonly string[];
  #at = 0;

  constructor(tokens: readonly string[]) {
    this.#tokens = tokens;
  }

  get isAtEnd(): boolean {
    return this.#at >= this.#tokens.length;
  }

  /** White space and comments. */
  blank(): string[] {
    const start = this.#at;
    while (!this.isAtEnd && BLANK.test(this.#tokens[this.#at]!)) this.#at++;
    return this.#tokens.slice(start, this.#at);
  }

  /** An import, if one is next, without its semicolon. */
  imports(): string | undefined {
    if (this.#tokens[this.#at] !== "import") return undefined;
    const start = this.#at;
    this.#at = this.#tokens.indexOf(";", start) + 1;
    return this.#tokens.slice(start, this.#at - 1).join("");
  }

  /** A declaration, a statement, a block, or a member of a struct, with the condition it is under. */
  statement(isMember: boolean): Part[] {
    const parts: Part[] = [];
    let isStruct = false;
    for (let depth = 0; !this.isAtEnd; ) {
      const token = this.#tokens[this.#at]!;
      if (token === "@" && this.#tokens[this.#at + 1] === "if") {
        this.#at += 2;
        const condition = this.#condition();
        this.blank();
        return [...parts, { condition, parts: this.statement(isMember) }];
      }
      if (isMember && token === "}") return parts;
      this.#at++;
      parts.push(token);
      if (token === "(" || (isMember && token === "<")) depth++;
      else if (token === ")" || (isMember && token === ">")) depth--;
      else if (token === "struct") isStruct = true;
      else if (token === "{") {
        parts.push(...this.#block(isStruct));
        const end = this.#at;
        const blank = this.blank();
        if (this.#tokens[this.#at] !== "else") {
          this.#at = end;
          return parts;
        }
        parts.push(...blank);
      } else if (depth === 0 && (token === ";" || (isMember && token === ","))) return parts;
    }
    return parts;
  }

  /** What follows an opening brace, to the closing one. */
  #block(isStruct: boolean): Part[] {
    const parts: Part[] = [];
    for (;;) {
      parts.push(...this.blank());
      if (this.isAtEnd) return parts;
      if (this.#tokens[this.#at] === "}") {
        parts.push(this.#tokens[this.#at++]!);
        return parts;
      }
      parts.push(...this.statement(isStruct));
    }
  }

  /** The tokens in the parentheses that follow. */
  #condition(): string[] {
    const start = this.#at + 1;
    for (let depth = 0; ; this.#at++) {
      const token = this.#tokens[this.#at];
      if (token === "(") depth++;
      if (token === ")" && --depth === 0) break;
    }
    return this.#tokens.slice(start, this.#at++).filter((token) => !BLANK.test(token));
  }
}

/** The tokens of all parts, whatever the conditions. */
function flat(parts: readonly Part[]): string[] {
  return parts.flatMap((part) => (typeof part === "string" ? part : flat(part.parts)));
}

/** The tokens of those parts whose conditions hold. */
function select(parts: readonly Part[], conditions: Conditions): string[] {
  return parts.flatMap((part) => {
    if (typeof part === "string") return part;
    return holds(part.condition, conditions) ? select(part.parts, conditions) : [];
  });
}

/** Whether an expression of `!`, `&&`, `||`, parentheses and names is true; an empty one is. */
function holds(tokens: Condition, conditions: Conditions): boolean {
  let at = 0;
  const operand = (): boolean => {
    const token = tokens[at++]!;
    if (token === "!") return !operand();
    if (token !== "(") return conditions[token] ?? false;
    const value = either();
    at++;
    return value;
  };
  const both = (): boolean => {
    let value = operand();
    while (tokens[at] === "&&") {
      at++;
      value = operand() && value;
    }
    return value;
  };
  const either = (): boolean => {
    let value = both();
    while (tokens[at] === "||") {
      at++;
      value = both() || value;
    }
    return value;
  };
  return tokens.length === 0 || either();
}
