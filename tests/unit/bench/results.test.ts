import { expect, test } from "vitest";
import { adapterLabel, placeOf, slugOf } from "../../bench/results";
import { parseLines } from "../../bench/rivals";

test.each([
  "google · swiftshader · SwiftShader Device (Subzero)",
  "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader driver)",
])("a software adapter is called one, whatever layer names it: %s", (adapter) => {
  expect(adapterLabel(adapter)).toBe("SwiftShader (software, no GPU)");
  expect(slugOf(adapter)).toBe("swiftshader");
});

test("a GPU keeps its name, and gives a file a short one", () => {
  expect(adapterLabel("nvidia · turing")).toBe("nvidia · turing");
  expect(slugOf("nvidia · turing")).toBe("nvidia-turing");
});

test("a host is named with its adapter, Python by its threads", () => {
  expect(placeOf({ host: "Chromium", adapter: "apple · metal-3" })).toBe("Chromium, apple · metal-3");
  expect(placeOf({ host: "Python", adapter: "CPU, 2 threads" })).toBe("CPU, 2 threads");
});

test("what a rival prints besides its lines of JSON is passed over", () => {
  expect(parseLines('Fra:1 Mem:2M\n{"samples":4}\n\n{"samples":16}\nBlender quit\n')).toEqual([
    { samples: 4 },
    { samples: 16 },
  ]);
});
