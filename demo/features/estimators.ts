import "rt-viewer/element";

const [uniform] = document.querySelectorAll("rt-viewer");

uniform!.settings = { estimator: "uniform" };
