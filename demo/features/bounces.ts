import "rt-viewer/element";

const viewer = document.querySelector("rt-viewer")!;
const slider = document.querySelector("input")!;
const label = document.querySelector("output")!;

slider.addEventListener("input", () => {
  viewer.maxBounces = slider.valueAsNumber;
  label.value = slider.value;
});
