const PI = 3.14159265358979;
const TWO_PI = 6.28318530717959;
const INV_PI = 0.318309886183791;

// Length of a ray that hits nothing. Squares of distances up to here stay finite in f32.
const FAR = 1e18;

// Distance of a hit that rounding would put at or behind the ray's origin. Its square is not subnormal.
const NEAR = 1e-18;

// What divides in place of smaller squares of distances, and of 0: quotients stay finite.
const NEAR2 = 1e-36;

// The same for cosines and other components of unit vectors.
const LEAST_COMPONENT = 1e-18;

// "No primitive": the source of a camera ray, the result of a ray that escapes.
const NONE = 0xffffffffu;

// Set in Ray.source when a ray starts on the inner side of a closed primitive, which it may then hit again from inside.
const INSIDE = 0x80000000u;
