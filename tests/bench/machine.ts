import { arch, cpus, release, type } from "node:os";
import type { Machine } from "./results";

/** What this machine is, for whoever reads the figures. @param chromium - its version, if it took part. */
export function describeMachine(chromium: string | undefined): Machine {
  const cores = cpus();
  return {
    cpu: cores[0]?.model.trim() ?? "unknown",
    cores: cores.length,
    system: `${type()} ${release()} ${arch()}`,
    node: process.versions.node,
    ...(chromium !== undefined && { chromium }),
    date: new Date().toISOString().slice(0, 10),
  };
}
