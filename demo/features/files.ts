import "rt-viewer/element";

const viewer = document.querySelector("rt-viewer")!;
const input = document.querySelector("input")!;
const status = document.querySelector<HTMLElement>("[role=status]")!;

viewer.drop = true; // the attribute drop
input.addEventListener("change", async () => {
  status.textContent = "";
  try {
    await viewer.open(...(input.files ?? []));
  } catch (error) {
    status.textContent = (error as Error).message;
  }
});

viewer.addEventListener("loadwarnings", ({ detail }) => {
  status.textContent = detail.warnings.join(" ");
});
