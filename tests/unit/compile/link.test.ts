import { describe, expect, test } from "vitest";
import { link as linkByWesl } from "wesl/core";
import { type CompiledScene, compileScene } from "../../../src/compile/compileScene";
import type { ProgramSettings } from "../../../src/compile/features";
import { type Conditions, link, parseModule } from "../../../src/compile/link";
import { linkModule, linkProgram } from "../../../src/compile/linkProgram";
import { parseScene } from "../../../src/scene/parseScene";
import type { Scene } from "../../../src/scene/schema";
import { prepareGeometry } from "../../../src/tree/geometry";
import { CROWDS, LIGHTS, MATERIALS, meshScenes, PRIMITIVES, placedScene, sceneOf } from "../../shaders/programs";
import { loadReference, REFERENCE_NAMES } from "../../support/reference";
import { SHADER_MODULES } from "../../support/shaderModules";

/** The declarations of a program in alphabetical order, without comments, last commas, and white space where none is needed. */
function declarationsOf(wgsl: string): string[] {
  const declarations: string[] = [];
  let depth = 0;
  let declaration = "";
  for (const token of wgsl.replaceAll(/\/\/.*/g, "").match(/\w+|\s+|[\s\S]/g)!) {
    if (/^[({[]$/.test(token)) depth++;
    if (/^[)}\]]$/.test(token)) depth--;
    declaration += token;
    if (depth > 0 || (token !== ";" && token !== "}")) continue;
    const tight = declaration.replaceAll(/\s+/g, " ").replaceAll(/ ?([^\w@]) ?/g, "$1");
    declarations.push(tight.replaceAll(/,(?=[)}])/g, "").trim());
    declaration = "";
  }
  return declarations.filter(Boolean).sort();
}

async function expectSame(
  wgsl: string,
  root: string,
  modules: Readonly<Record<string, string>>,
  conditions: Conditions,
) {
  const weslSrc = Object.fromEntries(
    Object.entries({ ...SHADER_MODULES, ...modules }).map(([path, text]) => [`./${path}.wgsl`, text]),
  );
  const { dest } = await linkByWesl({ weslSrc, rootModuleName: root, conditions });
  // wesl-js also renames what has the name of some local variable.
  const ours = new Set(namesOf(wgsl));
  const renamed = namesOf(dest).filter((name) => !ours.has(name));
  const named = renamed.reduce(
    (text, name) => text.replaceAll(new RegExp(`\\b${name}\\b`, "g"), name.replace(/\d$/, "")),
    dest,
  );
  expect(declarationsOf(wgsl)).toEqual(declarationsOf(named).filter((each) => !isIdle(each, named)));
}

/** An alias that nothing names: wesl-js keeps those of members of structs that conditions leave out. */
function isIdle(declaration: string, wgsl: string): boolean {
  const alias = /^alias (\w+)=/.exec(declaration)?.[1];
  return alias !== undefined && wgsl.match(new RegExp(`\\b${alias}\\b`, "g"))!.length === 1;
}

function namesOf(wgsl: string): string[] {
  return [...wgsl.matchAll(/\b(?:fn|struct|const|var<.*>) (\w+)/g)].map(([, name]) => name!);
}

async function expectSamePrograms(scene: Scene) {
  const resolved = parseScene(scene);
  const geometry = await prepareGeometry(resolved);
  for (const estimator of ["path", "uniform"] as const) {
    const settings: ProgramSettings = {
      estimator,
      sampler: estimator === "path" ? "sobol" : "independent",
      lightSamples: estimator === "path" ? 1 : 2,
    };
    for (const camera of [undefined, resolved.camera]) {
      const { sceneModule, features }: CompiledScene = compileScene(resolved, settings, camera, geometry);
      const modules = {
        scene: sceneModule,
        estimator: SHADER_MODULES[estimator === "path" ? "path" : "baseline"]!,
      };
      for (const root of ["trace", "pick"] as const) {
        const conditions = { ...features, PICK: root === "pick" };
        await expectSame(await linkProgram(sceneModule, features, root), root, modules, conditions);
      }
    }
  }
}

describe("a program is the one that wesl-js links", () => {
  test.each(REFERENCE_NAMES)("for %s", async (name) => {
    await expectSamePrograms(loadReference(name).scene);
  });

  test.each(Object.entries(MATERIALS))("for shapes and meshes of %s", async (_name, material) => {
    for (const scene of [...meshScenes(material), placedScene(material)]) await expectSamePrograms(scene);
    const lights = LIGHTS["lights of both kinds"]!;
    await expectSamePrograms(sceneOf(Object.values(PRIMITIVES), { m: material }, lights, [0, 0, 0]));
  });

  test("for a lens", async () => {
    const scene = loadReference("spheres").scene;
    await expectSamePrograms({ ...scene, camera: { ...scene.camera, aperture: 0.1 } });
  });

  test.each(Object.entries(CROWDS))("for %s", async (_name, { objects, lights }) => {
    await expectSamePrograms(sceneOf(objects, { m: {}, ...MATERIALS }, lights, [1, 1, 1]));
  });

  test.each(["blit", "error"])("for %s", async (root) => {
    await expectSame(await linkModule(root), root, {}, {});
  });
});

describe("modules", () => {
  const linked = (modules: Readonly<Record<string, string>>, conditions: Conditions = {}) => {
    const parsed = new Map(Object.entries(modules).map(([path, text]) => [path, parseModule(text)]));
    return link((path) => parsed.get(path), "main", conditions);
  };
  const only = (text: string, conditions: Conditions = {}) => declarationsOf(linked({ main: text }, conditions));

  test("give what is made use of, directly or not, and nothing else", () => {
    const a = "import package::b::{g};\nfn f() { g(); }\nfn unused() { other(); }";
    const b = "const ONE = 1.0;\nfn g() -> f32 { return ONE; }\nfn h() {}";
    expect(declarationsOf(linked({ main: "import package::a::f;\nfn main() { f(); }", a, b }))).toEqual([
      "const ONE=1.0;",
      "fn f(){g();}",
      "fn g()->f32{return ONE;}",
      "fn main(){f();}",
    ]);
  });

  test("are found by full names in folders, and in a circle", () => {
    const main = "fn main() { package::a::b::f(); }";
    expect(declarationsOf(linked({ main, "a/b": "fn f() { package::main::g(); }" }))).toEqual([
      "fn f(){g();}",
      "fn main(){f();}",
    ]);
  });

  test("may each have a declaration of the same name", () => {
    const main = "import package::a::f;\nconst X = 1;\nfn main() { f(X); }";
    expect(declarationsOf(linked({ main, a: "const X = 2;\nfn f(x: i32) { g(x.X, X); }" }))).toEqual([
      "const X0=2;",
      "const X=1;",
      "fn f(x:i32){g(x.X,X0);}",
      "fn main(){f(X);}",
    ]);
  });

  test.each<[string, Conditions, string[]]>([
    ["@if(A) const X = 1;\n@if(!A) const X = 2;", { A: true }, ["const X=1;"]],
    ["@if(A) const X = 1;\n@if(!A) const X = 2;", {}, ["const X=2;"]],
    [
      "struct S { @if(A) a: vec2<f32>, // a, b;\n @if(B && !A) b: f32,\n c: u32 }",
      { A: true, B: true },
      ["struct S{a:vec2<f32>,c:u32}"],
    ],
    ["struct S { c: u32, @if(A) a: f32 }", {}, ["struct S{c:u32}"]],
    ["fn f() { @if(A) { g(); } h(); }", {}, ["fn f(){h();}"]],
    ["fn f() { @if(A || B) if (x) { g(); } else if (y) { i(); } else { j(); } h(); }", {}, ["fn f(){h();}"]],
    ["fn f() { @if(A) for (var i = 0; i < 3; i++) { @if(B) g(i); } }", { A: true }, ["fn f(){for(var i=0;i<3;i++){}}"]],
    ["fn f() { @if((A || B) && !(A && B)) return; }", { A: true, B: true }, ["fn f(){}"]],
    [
      "@if(A) @group(0) @binding(1) var<storage, read> x: array<vec4f, 3>;",
      { A: true },
      ["@group(0)@binding(1)var<storage,read>x:array<vec4f,3>;"],
    ],
  ])("keep of %s what holds under %o", (text, conditions, declarations) => {
    expect(only(text, conditions)).toEqual(declarations);
  });

  test("that nobody has leave the names they should declare", () => {
    expect(only("import package::b::g;\nfn f() { g(); }")).toEqual(["fn f(){g();}"]);
  });
});
