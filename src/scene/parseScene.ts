import type * as v from "valibot";
import { SceneError } from "../errors";
import { Report } from "./report";
import { CameraSchema, type ResolvedCamera, type ResolvedScene, SceneSchema } from "./schema";

/**
 * Checks a scene, as written in TypeScript or read from JSON, and fills in every default. Each value is read once: what is
 * checked is what is returned.
 *
 * @returns new data that shares nothing with the input, but for texels that a loader made or that were returned before.
 * `materials` has no prototype, and holds every name an object uses.
 * @throws {SceneError} with the first 100 issues, and the number of all. Nothing else is thrown, whatever the input.
 */
export function parseScene(input: unknown): ResolvedScene {
  return parse(SceneSchema, input);
}

/** Checks a camera alone, as `parseScene` does a scene. */
export function parseCamera(input: unknown): ResolvedCamera {
  return parse(CameraSchema, input);
}

function parse<In, Out>(schema: v.GenericSchema<In, Out>, input: unknown): Out {
  const report = new Report();
  let output: Out | undefined;
  try {
    output = report.parseWhole(schema, input);
  } catch (cause) {
    // The input itself threw: a getter, a revoked proxy.
    throw new SceneError([{ path: "", message: "expected plain data; reading it threw the error in `cause`" }], {
      cause,
    });
  }
  if (!report.isEmpty) throw report.toError();
  return output as Out;
}
