// What is wrong with a scene, as it is found.
//
// valibot hands the issues of a part on to the whole, level by level, each time as new objects: a file of 13 MB with a million
// of them took a minute. Here the first are kept, with their paths, and the rest only counted.

import type * as v from "valibot";
import { SceneError, type SceneIssue } from "../errors";
import { formatPath } from "./describe";
import { MAX_ISSUES } from "./issueLimit";

type Key = string | number;

/** The issues found so far. It goes with the parsers wherever they go, and knows where they are. */
export class Report {
  readonly #issues: SceneIssue[] = [];
  #count = 0;
  readonly #path: Key[] = [];
  /** valibot gives it to whoever it calls. */
  readonly #config: ReportConfig = { report: this };

  /** The report of the parse that is under way, from what valibot gives its actions. */
  static of(config: object): Report {
    return (config as ReportConfig).report;
  }

  get isEmpty(): boolean {
    return this.#count === 0;
  }

  /**
   * Parses the value at `key` of what is being parsed, and adds what is wrong with it.
   *
   * @returns what became of it; `undefined` if it is at fault. An object, list or dictionary holds what is sound in it.
   */
  parse<In, Out>(schema: v.GenericSchema<In, Out>, value: unknown, key: Key): Out | undefined {
    this.#path.push(key);
    const output = this.parseWhole(schema, value);
    this.#path.pop();
    return output;
  }

  /** Like `parse`, of the same value as another schema. */
  parseWhole<In, Out>(schema: v.GenericSchema<In, Out>, value: unknown): Out | undefined {
    const { value: output, issues } = schema["~run"]({ value }, this.#config);
    if (issues === undefined) return output as Out;
    for (const { message } of issues) this.add(message);
    return undefined;
  }

  /** Adds an issue, `keys` further in than where the parsers are. */
  add(message: string | (() => string), ...keys: readonly Key[]): void {
    this.#count += 1;
    if (this.#issues.length === MAX_ISSUES) return;
    const path = formatPath([...this.#path, ...keys]);
    this.#issues.push({ path, message: typeof message === "string" ? message : message() });
  }

  toError(): SceneError {
    return new SceneError(this.#issues, { issueCount: this.#count });
  }
}

type ReportConfig = v.Config<v.BaseIssue<unknown>> & { readonly report: Report };
