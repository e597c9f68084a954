// Measured complex indices of refraction, n + ik, over the visible range.
//
// The rows of the papers' tables from about 380 to 820 nm, as kept by refractiveindex.info (public domain, CC0): pure
// elements, smooth films, room temperature. Samples differ: the green of gold comes out as 0.73 with [1] and 0.77 with [4],
// and published reflectances of titanium run from 0.4 to 0.6.
//
// [1] Johnson, Christy 1972, "Optical Constants of the Noble Metals", Phys. Rev. B 6, 4370
// [2] Johnson, Christy 1974, "Optical constants of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd", Phys. Rev. B 9, 5056
// [3] Rakić 1995, "Algorithm for the determination of intrinsic optical constants of metal films: application to aluminum",
//     Appl. Opt. 34, 4755
// [4] Babar, Weaver 2015, "Optical constants of Cu, Ag, and Au revisited", Appl. Opt. 54, 477

/** Rows of `[wavelength in nm, n, k]`, by ascending wavelength. */
export type OpticalConstants = readonly (readonly [nm: number, n: number, k: number])[];

// [4]
// biome-ignore format: a table
export const GOLD: OpticalConstants = [
  [387.5, 1.568, 1.824], [399.9, 1.569, 1.839], [413.3, 1.559, 1.825], [427.5, 1.530, 1.811], [442.8, 1.486, 1.797],
  [459.2, 1.457, 1.736], [476.9, 1.266, 1.560], [495.9, 0.8564, 1.629], [516.6, 0.5020, 1.853], [539.1, 0.3290, 2.249],
  [563.6, 0.2452, 2.569], [590.4, 0.1823, 2.880], [619.9, 0.1357, 3.204], [652.5, 0.1091, 3.529], [688.8, 0.08524, 3.871],
  [729.3, 0.07661, 4.242], [774.9, 0.07883, 4.630], [826.6, 0.08019, 5.050],
];

// [4]
// biome-ignore format: a table
export const SILVER: OpticalConstants = [
  [387.5, 0.050, 1.981], [399.9, 0.054, 2.138], [413.3, 0.050, 2.292], [427.5, 0.051, 2.448], [442.8, 0.052, 2.604],
  [459.2, 0.052, 2.765], [476.9, 0.053, 2.930], [495.9, 0.052, 3.105], [516.6, 0.052, 3.288], [539.1, 0.05168, 3.483],
  [563.6, 0.05009, 3.694], [590.4, 0.04977, 3.918], [619.9, 0.04803, 4.164], [652.5, 0.04964, 4.432], [688.8, 0.05080, 4.725],
  [729.3, 0.05151, 5.048], [774.9, 0.05269, 5.409], [826.6, 0.05504, 5.814],
];

// [1]
// biome-ignore format: a table
export const COPPER: OpticalConstants = [
  [381.5, 1.33, 2.045], [397.4, 1.32, 2.116], [413.3, 1.28, 2.207], [430.5, 1.25, 2.305], [450.9, 1.24, 2.397],
  [471.4, 1.25, 2.483], [495.9, 1.22, 2.564], [520.9, 1.18, 2.608], [548.6, 1.02, 2.577], [582.1, 0.70, 2.704],
  [616.8, 0.30, 3.205], [659.5, 0.22, 3.747], [704.5, 0.21, 4.205], [756.0, 0.24, 4.665], [821.1, 0.26, 5.180],
];

// [3]
// biome-ignore format: a table
export const ALUMINIUM: OpticalConstants = [
  [364.66, 0.39877, 4.3957], [413.28, 0.52135, 5.0008], [442.80, 0.60790, 5.3676], [476.87, 0.72780, 5.7781], [516.60, 0.87340, 6.2418],
  [563.57, 1.0728, 6.7839], [619.93, 1.3660, 7.4052], [652.25, 1.5724, 7.7354], [688.81, 1.8301, 8.0601], [729.32, 2.1606, 8.3565],
  [774.91, 2.6154, 8.4914], [794.78, 2.7675, 8.3866],
];

// [2]
// biome-ignore format: a table
export const IRON: OpticalConstants = [
  [381, 2.12, 2.50], [397, 2.24, 2.58], [413, 2.35, 2.65], [431, 2.48, 2.71], [451, 2.59, 2.77],
  [471, 2.67, 2.82], [496, 2.74, 2.88], [521, 2.86, 2.91], [549, 2.95, 2.93], [582, 2.94, 2.99],
  [617, 2.88, 3.05], [659, 2.92, 3.10], [704, 2.86, 3.19], [756, 2.87, 3.28], [821, 2.94, 3.39],
];

// [2]
// biome-ignore format: a table
export const TITANIUM: OpticalConstants = [
  [381, 1.99, 2.93], [397, 2.08, 2.95], [413, 2.14, 2.98], [431, 2.21, 3.01], [451, 2.27, 3.04],
  [471, 2.32, 3.10], [496, 2.36, 3.19], [521, 2.44, 3.30], [549, 2.54, 3.43], [582, 2.60, 3.58],
  [617, 2.67, 3.72], [659, 2.76, 3.84], [704, 2.86, 3.96], [756, 3.00, 4.01], [821, 3.21, 4.01],
];

// [2]
// biome-ignore format: a table
export const CHROMIUM: OpticalConstants = [
  [381, 1.92, 2.74], [397, 2.00, 2.83], [413, 2.08, 2.93], [431, 2.19, 3.04], [451, 2.33, 3.14],
  [471, 2.51, 3.24], [496, 2.75, 3.30], [521, 2.94, 3.33], [549, 3.18, 3.33], [582, 3.22, 3.30],
  [617, 3.17, 3.30], [659, 3.09, 3.34], [704, 3.05, 3.39], [756, 3.08, 3.42], [821, 3.20, 3.48],
];
