import { execFile } from "node:child_process";
import { cp, mkdir, mkdtemp, readdir, rm, symlink } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";

const run = promisify(execFile);
const REPOSITORY = fileURLToPath(new URL("../../../", import.meta.url));
const TEMPLATE = fileURLToPath(new URL("../stranger/", import.meta.url));
/** What the project needs besides the package; taken from here, because downloading it again would only take time. */
const TOOLS = ["typescript", "vite", "react", "react-dom", "@types/react", "@types/react-dom", "vue", "svelte"];

/** Somebody else's project, outside of the repository, with the package installed as from a registry. */
export class Project {
  readonly folder: string;

  /** Packs the package as last built, installs the tarball and its dependencies, and builds the project. */
  static async create(): Promise<Project> {
    const folder = await mkdtemp(join(tmpdir(), "rt-viewer-stranger-"));
    await cp(TEMPLATE, folder, { recursive: true });
    await run("npm", ["pack", "--ignore-scripts", "--pack-destination", folder], { cwd: REPOSITORY });
    const tarball = (await readdir(folder)).find((name) => name.endsWith(".tgz"));
    const quietly = ["--prefer-offline", "--no-audit", "--no-fund", "--ignore-scripts"];
    await run("npm", ["install", ...quietly, `./${tarball}`], { cwd: folder });
    for (const name of TOOLS) {
      const link = join(folder, "node_modules", name);
      await mkdir(dirname(link), { recursive: true });
      await symlink(join(REPOSITORY, "node_modules", name), link, "dir");
    }
    const project = new Project(folder);
    await project.vite("build");
    return project;
  }

  private constructor(folder: string) {
    this.folder = folder;
  }

  /** Where the installed package is. */
  get package(): string {
    return join(this.folder, "node_modules/rt-viewer");
  }

  /**
   * Runs a program with Node, in the project's folder.
   *
   * @returns what it printed.
   * @throws with what it printed, if it fails.
   */
  async node(...args: readonly string[]): Promise<string> {
    try {
      const { stdout } = await run(process.execPath, args, { cwd: this.folder });
      return stdout;
    } catch (error) {
      const { stdout, stderr } = error as { stdout: string; stderr: string };
      throw new Error(`node ${args.join(" ")}\n${stdout}${stderr}`);
    }
  }

  tsc(...args: readonly string[]): Promise<string> {
    return this.node("node_modules/typescript/bin/tsc", ...args);
  }

  vite(...args: readonly string[]): Promise<string> {
    return this.node("node_modules/vite/bin/vite.js", ...args);
  }

  dispose(): Promise<void> {
    return rm(this.folder, { recursive: true, force: true });
  }
}
