// Runs a TypeScript program of this repository in Node, with the transforms the package itself is built with.
import { createRunnableDevEnvironment, resolveConfig } from "vite";

// Vite's own runnerImport is this, but closes the runner at once: what a program imports later would fail.
const environments = {
  program: { consumer: "server", resolve: { external: true, mainFields: [], conditions: ["node"] } },
};
const config = await resolveConfig({ configFile: false, envDir: false, logLevel: "error", environments }, "serve");
const environment = createRunnableDevEnvironment("program", config, {
  runnerOptions: { hmr: { logger: false } },
  hot: false,
});
await environment.init();

const [entry, ...args] = process.argv.slice(2);
process.argv = [process.argv[0], entry, ...args];
const { main } = await environment.runner.import(`./${entry}`);
await main(args);
await environment.close();
