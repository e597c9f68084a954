import { createRoot, hydrateRoot } from "react-dom/client";
import { App } from "./App.tsx";

const root = document.querySelector("#root")!;
if (root.childElementCount > 0) hydrateRoot(root, <App />);
else createRoot(root).render(<App />);
