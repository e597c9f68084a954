/** What is under way between a request for a scene and its picture: its file, its acceleration structure, its shader. */
export type LoadPhase = "fetching" | "building" | "compiling";

/** `loadprogress`: how far the scene is that was asked for. */
export type LoadProgressDetail = {
  readonly phase: LoadPhase;
  /** Of this phase, 0…1; `undefined` where nobody knows. */
  readonly fraction: number | undefined;
};

/** To be called by whoever does the work, as often as it likes. */
export type ReportProgress = (phase: LoadPhase, fraction?: number) => void;
