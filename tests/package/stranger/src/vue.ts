import "rt-viewer/vue";
import { createApp, h, ref } from "vue";

const samples = ref(0);

// What the compiler makes of <rt-viewer controls stats src="spheres.json" :target-error="0.05" @progress="…">.
createApp(() => [
  h("rt-viewer", {
    style: { width: "320px", height: "240px" },
    controls: "",
    stats: "",
    src: "spheres.json",
    "target-error": 0.05,
    onProgress: ({ detail }: CustomEvent<{ samples: number }>) => {
      samples.value = detail.samples;
    },
  }),
  h("output", `${samples.value} samples`),
]).mount("#root");
