import "rt-viewer/react";
import { useRef, useState } from "react";
import type { RtViewerElement } from "rt-viewer/element";

/** What a page in React does: attributes, properties, listeners and a reference. */
export function App() {
  const viewer = useRef<RtViewerElement>(null);
  const [samples, setSamples] = useState(0);
  const [isReady, setReady] = useState(false);
  return (
    <main>
      <rt-viewer
        ref={viewer}
        className="picture"
        style={{ width: 320, height: 240 }}
        src="spheres.json"
        alt="Three balls"
        controls
        stats="folded"
        max-bounces={4}
        maxSamples={64}
        settings={{ seed: 2 }}
        onready={({ detail }) => setReady(detail.tracer === viewer.current?.tracer)}
        onprogress={(event) => setSamples(event.detail.samples)}
      />
      <output>{isReady ? `${samples} samples` : "…"}</output>
    </main>
  );
}
