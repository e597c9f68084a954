import { expect, test } from "vitest";
import { OBSERVED_ATTRIBUTES } from "../../../src/element/attributes";
import type { RtViewerAttributes } from "../../../src/frameworks/attributes";

test("templates may write every attribute of the element, and no other", () => {
  const attributes: Required<RtViewerAttributes> = {
    src: "scene.json",
    "variant-name": "Night",
    controls: true,
    stats: "folded",
    paused: false,
    alt: "",
    exposure: 0,
    poster: "poster.png",
    loading: "lazy",
    "camera-orbit": "30deg 15deg 5m",
    "tone-map": "agx",
    drop: true,
    "max-bounces": 8,
    "samples-per-frame": 1,
    "light-samples": "1",
    "target-error": 0.01,
    "max-samples": 64,
  };
  expect(Object.keys(attributes).sort()).toEqual([...OBSERVED_ATTRIBUTES].sort());
});
