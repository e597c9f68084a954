import { testDevice } from "./device";
import { type Probe, probeOn } from "./probeOn";

/** `probeOn` the device of the tests. */
export async function runProbe(probe: Probe): Promise<Uint32Array> {
  return probeOn(await testDevice(), probe);
}
