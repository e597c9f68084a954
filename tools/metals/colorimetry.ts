// The colour of a reflectance spectrum under daylight.
//
// [1] Wyman, Sloan, Shirley 2013, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", JCGT 2(2)
// [2] CIE standard illuminant D65, ISO 11664-2 (CIE S 014-2)
// [3] Rec. ITU-R BT.709-6: primaries and white, from which the matrix follows

import type { Rgb } from "../../src/scene/schema";

const FIRST_NM = 390;
const STEP_NM = 10;

// Relative power of D65 [2] from 390 to 780 nm; outside, the matching functions are below about 1 % of their peaks.
// biome-ignore format: ten wavelengths to a line
const D65 = [
   54.6482,  82.7549,  91.4860,  93.4318,  86.6823, 104.8650, 117.0080, 117.8120, 114.8610, 115.9230, // 390 – 480
  108.8110, 109.3540, 107.8020, 104.7900, 107.6890, 104.4050, 104.0460, 100.0000,  96.3342,  95.7880, // 490 – 580
   88.6856,  90.0062,  89.5991,  87.6987,  83.2886,  83.6992,  80.0268,  80.2146,  82.2778,  78.2842, // 590 – 680
   69.7213,  71.6091,  74.3490,  61.6040,  69.8856,  75.0870,  63.5927,  46.4182,  66.8054,  63.3828, // 690 – 780
];

/**
 * The colour, linear Rec. 709 clipped to [0, 1], of a surface lit by D65.
 *
 * @param reflectanceAt - the reflectance, 0 to 1, at a wavelength in nm; asked from 390 to 780. Constant 1 gives exactly white.
 */
export function reflectanceToRgb(reflectanceAt: (nm: number) => number): Rgb {
  const color = rgbUnderD65(reflectanceAt);
  const white = rgbUnderD65(() => 1); // within 0.3 % of grey: what is left of the error of [1] is divided out
  const channel = (i: 0 | 1 | 2) => Math.min(1, Math.max(0, color[i] / white[i]));
  return [channel(0), channel(1), channel(2)];
}

function rgbUnderD65(reflectanceAt: (nm: number) => number): Rgb {
  let [x, y, z] = [0, 0, 0];
  D65.forEach((power, i) => {
    const nm = FIRST_NM + i * STEP_NM;
    const reflected = power * reflectanceAt(nm);
    x += reflected * matchX(nm);
    y += reflected * matchY(nm);
    z += reflected * matchZ(nm);
  });
  // XYZ to linear Rec. 709 [3]
  return [
    3.2404542 * x - 1.5371385 * y - 0.4985314 * z,
    -0.969266 * x + 1.8760108 * y + 0.041556 * z,
    0.0556434 * x - 0.2040259 * y + 1.0572252 * z,
  ];
}

// [1], the multi-lobe fits: Gaussians with a slope of their own on either side of the peak.
function matchX(nm: number): number {
  return (
    lobe(nm, 0.362, 442, 0.0624, 0.0374) +
    lobe(nm, 1.056, 599.8, 0.0264, 0.0323) +
    lobe(nm, -0.065, 501.1, 0.049, 0.0382)
  );
}

function matchY(nm: number): number {
  return lobe(nm, 0.821, 568.8, 0.0213, 0.0247) + lobe(nm, 0.286, 530.9, 0.0613, 0.0322);
}

function matchZ(nm: number): number {
  return lobe(nm, 1.217, 437, 0.0845, 0.0278) + lobe(nm, 0.681, 459, 0.0385, 0.0725);
}

function lobe(nm: number, height: number, peakNm: number, slopeBelow: number, slopeAbove: number): number {
  const t = (nm - peakNm) * (nm < peakNm ? slopeBelow : slopeAbove);
  return height * Math.exp(-0.5 * t * t);
}
