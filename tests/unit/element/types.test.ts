import { expectTypeOf, it } from "vitest";
import type { LoadPhase, RtViewerElement } from "../../../src/element";
import type { Rgb } from "../../../src/index";
import type { Stats } from "../../../src/renderer/stats";

it("listeners know the details of the element's events, and the events of any element", () => {
  const listen = (viewer: RtViewerElement) => {
    viewer.addEventListener("ready", ({ detail }) => expectTypeOf(detail.milliseconds).toBeNumber());
    viewer.addEventListener("progress", ({ detail }) => expectTypeOf(detail.samples).toBeNumber());
    viewer.addEventListener("loadprogress", ({ detail }) => expectTypeOf(detail.phase).toEqualTypeOf<LoadPhase>());
    viewer.addEventListener("devicelost", ({ detail }) => expectTypeOf(detail.count).toBeNumber());
    viewer.addEventListener("error", ({ detail }) => expectTypeOf(detail.error).toEqualTypeOf<Error>());
    viewer.addEventListener("pick", ({ detail }) => {
      if (detail.kind === "object") expectTypeOf(detail.object.material).toBeString();
      if (detail.kind === "light" && detail.light.type === "sphere") {
        expectTypeOf(detail.light.power).toEqualTypeOf<Rgb>();
      }
    });
    viewer.addEventListener("keydown", ({ key }) => expectTypeOf(key).toBeString());
    viewer.addEventListener("something-else", (event) => expectTypeOf(event).toEqualTypeOf<Event>());
  };
  expectTypeOf(listen).toBeFunction();
});

it("the document knows the tag", () => {
  const find = (page: Document) => page.querySelector("rt-viewer");
  expectTypeOf(find).returns.toEqualTypeOf<RtViewerElement | null>();
});

it("any element's listener knows the events that no other element has", () => {
  const listen = (page: HTMLElement) => {
    page.addEventListener("converged", ({ detail }) => expectTypeOf(detail.error).toBeNumber());
    page.addEventListener("devicelost", ({ detail }) => expectTypeOf(detail.message).toBeString());
    page.addEventListener("error", (event) => expectTypeOf(event).toEqualTypeOf<ErrorEvent>());
  };
  expectTypeOf(listen).toBeFunction();
});

it("stats are read as figures and written as a switch", () => {
  expectTypeOf<RtViewerElement["stats"]>().toEqualTypeOf<Stats | undefined>();
  const show = (viewer: RtViewerElement) => {
    viewer.stats = true;
  };
  expectTypeOf(show).toBeFunction();
});
