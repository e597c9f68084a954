import { describe, expect, test } from "vitest";
import { loadGltf } from "../../../src/loaders/gltf";
import { meshesOf, type TriangleJson, triangleFile } from "../../support/gltf";
import { growthOf, LINEAR } from "../../support/growth";

/** Where the meshes are, along x, and what is said. */
const load = async (change: (json: TriangleJson) => void) => {
  const { scene, warnings } = await loadGltf(triangleFile(change));
  return { scene, warnings, xs: meshesOf(scene).map(({ positions }) => positions[0]) };
};

const AS_ROOT = "The scene lists a node that is another's child: it is shown as a root, without its parent";
const ONE_PLACE = "A node has two parents, or is below itself: it is shown in one place only";
const NOTHING = "The file has no triangles, so there is nothing to see";

describe("nodes that are no forest", () => {
  test("a root that is another's child is shown as a root", async () => {
    const { xs, warnings } = await load((json) => {
      json.nodes = [
        { children: [1], translation: [5, 0, 0] },
        { mesh: 0, name: "model" },
      ];
      json.scenes = [{ nodes: [1] }];
    });
    expect(xs).toEqual([0]);
    expect(warnings).toEqual([`${AS_ROOT} (nodes[1] "model")`]);
  });

  test.each([[[0, 1]], [[1, 0]]])("a child listed with its parent, %j, is shown once, as a root", async (nodes) => {
    const { xs, warnings } = await load((json) => {
      json.nodes = [
        { children: [1], translation: [5, 0, 0] },
        { mesh: 0, translation: [1, 0, 0] },
      ];
      json.scenes = [{ nodes }];
    });
    expect(xs).toEqual([1]);
    expect(warnings).toEqual([`${AS_ROOT} (nodes[1])`]);
  });

  test("another scene may list a node as it likes", async () => {
    const { warnings } = await load((json) => {
      json.nodes = [{ children: [1] }, { mesh: 0 }];
      json.scenes = [{ nodes: [0] }, { nodes: [1, 1] }];
    });
    expect(warnings).toEqual(["Of 2 scenes only the default one is shown"]);
  });

  test("a node that is listed twice is shown once", async () => {
    const { xs, warnings } = await load((json) => {
      json.scenes = [{ nodes: [0, 0] }];
    });
    expect(xs).toEqual([0]);
    expect(warnings).toEqual(["The scene lists a node twice: it is shown once (nodes[0])"]);
  });

  test("a node of two parents is shown under the first", async () => {
    const { xs, warnings } = await load((json) => {
      json.nodes.push({ children: [0], translation: [5, 0, 0] }, { children: [0, 0], translation: [7, 0, 0] });
      json.scenes = [{ nodes: [1, 2] }];
    });
    expect(xs).toEqual([5]);
    expect(warnings).toEqual([`${ONE_PLACE} (nodes[0])`]);
  });

  test("a node that is its own child is shown once", async () => {
    const { xs, warnings } = await load((json) => {
      json.nodes[0].children = [0];
      json.scenes = json.scene = undefined;
    });
    expect(xs).toEqual([0]);
    expect(warnings).toEqual([`${ONE_PLACE} (nodes[0])`]);
  });

  test("a ring of nodes is cut, below a root or without any", async () => {
    const ring = (json: TriangleJson) => {
      json.nodes = [{ children: [1] }, { children: [2], translation: [3, 0, 0] }, { children: [1], mesh: 0 }];
    };
    const rooted = await load(ring);
    expect(rooted.xs).toEqual([3]);
    expect(rooted.warnings).toEqual([`${ONE_PLACE} (nodes[1])`]);
    const rootless = await load((json) => {
      ring(json);
      json.nodes[2].children = [0];
      json.scenes = json.scene = undefined;
    });
    expect(rootless.xs).toEqual([3]);
    expect(rootless.warnings).toEqual([`${ONE_PLACE} (nodes[0])`]);
  });

  test("thirty levels of two nodes that share their children take no longer than sixty nodes", async () => {
    const { xs } = await load((json) => {
      json.nodes = Array.from({ length: 60 }, (_, i) => ({
        children: i < 58 ? [i + 2 - (i % 2), i + 3 - (i % 2)] : [],
      }));
      json.nodes[59].mesh = 0;
    });
    expect(xs).toEqual([0]);
  });

  test("the time grows with the nodes, whoever their parents are", async () => {
    const tangle = (count: number) =>
      load((json) => {
        const random = (i: number) => (i * 7919 + 13) % count;
        json.nodes = Array.from({ length: count }, (_, i) => ({
          children: [random(i), random(i + 1), (i + 1) % count],
        }));
        json.scenes = [{ nodes: [...json.nodes.keys(), 0] }];
      });
    expect(await growthOf(tangle, 10_000)).toBeLessThan(LINEAR);
  });
});

describe("KHR_node_visibility", () => {
  const hidden = { KHR_node_visibility: { visible: false } };
  const shown = { KHR_node_visibility: { visible: true } };

  test("hides a node and all below it, whatever those say", async () => {
    const { xs, warnings } = await load((json) => {
      json.extensionsUsed = json.extensionsRequired = ["KHR_node_visibility"];
      json.nodes = [
        { mesh: 0, extensions: hidden, children: [1] },
        { mesh: 0, extensions: shown, children: [2] },
        { mesh: 0 },
        { mesh: 0, extensions: shown, translation: [4, 0, 0] },
        { mesh: 0, extensions: { KHR_node_visibility: {} }, translation: [5, 0, 0] },
      ];
      json.scenes = [{ nodes: [0, 3, 4] }];
    });
    expect(xs).toEqual([4, 5]);
    expect(warnings).toEqual([]);
  });

  test("hides lights and leaves cameras", async () => {
    const { scene, warnings } = await load((json) => {
      json.cameras = [{ type: "perspective", perspective: { yfov: 0.5, znear: 0.1 } }];
      json.extensions = { KHR_lights_punctual: { lights: [{ type: "point" }] } };
      json.nodes = [
        { mesh: 0, extensions: hidden, children: [1, 2] },
        { extensions: { KHR_lights_punctual: { light: 0 } } },
        { camera: 0, translation: [0, 0, 9] },
      ];
    });
    expect(scene.objects).toEqual([]);
    expect(scene.lights).toEqual([]);
    expect(scene.camera.position).toEqual([0, 0, 9]);
    expect(warnings).toEqual([NOTHING]);
  });
});
