import "rt-viewer/element";

const viewer = document.querySelector("rt-viewer")!;
const bar = document.querySelector("progress")!;
const text = document.querySelector("output")!;

viewer.addEventListener("progress", ({ detail: { samples, error } }) => {
  bar.value = (viewer.targetError / error) ** 2; // twice the samples, half the squared error
  text.value = `${(100 * error).toFixed(1)} % error after ${samples} samples`;
});
viewer.addEventListener("converged", ({ detail: { samples, error } }) => {
  text.value = `Done: ${(100 * error).toFixed(1)} % error after ${samples} samples`;
});
