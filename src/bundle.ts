// The package in one module, for pages without a bundler: <rt-viewer>, and everything else by name.

export * from "./element";
export * from "./index";
