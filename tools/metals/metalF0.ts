import { conductorF0 } from "../../src/scene/metals";
import type { Rgb } from "../../src/scene/schema";
import { reflectanceToRgb } from "./colorimetry";
import type { OpticalConstants } from "./opticalConstants";

/** The colour of a metal whose table covers 390 to 780 nm; n and k are interpolated linearly between its rows. */
export function metalF0(constants: OpticalConstants): Rgb {
  return reflectanceToRgb((nm) => {
    const next = constants.findIndex(([rowNm]) => rowNm >= nm);
    const [nm0, n0, k0] = constants[next - 1]!;
    const [nm1, n1, k1] = constants[next]!;
    const t = (nm - nm0) / (nm1 - nm0);
    return conductorF0(n0 + t * (n1 - n0), k0 + t * (k1 - k0));
  });
}
