// Runs a TypeScript program of this repository in Node, with the transforms the package itself is built with.
import { runnerImport } from "vite";

const [entry, ...args] = process.argv.slice(2);
process.argv = [process.argv[0], entry, ...args];
const { module } = await runnerImport(`./${entry}`, { logLevel: "error" });
await module.main(args);
