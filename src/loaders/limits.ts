// How much a file may ask for. A few bytes can claim anything, so this is checked before memory is taken.

/** Of a file that is fetched or dropped. A model of eight million triangles has 300 MB, and browsers give little more in one piece. */
export const MAX_FILE_BYTES = 2 ** 29;
/** After instancing. A million is a large model on the web; these take half a gigabyte. */
export const MAX_TRIANGLES = 2 ** 23;
/** After instancing. */
export const MAX_VERTICES = 2 ** 24;
/**
 * What all vertex data of a file may unpack to, what all that meshopt packed does, and all picture files together. Parts can share
 * bytes, so it can be more than the file has.
 */
export const MAX_UNPACKED_BYTES = 2 ** 30;
/** Meshes in the scene, after instancing. */
export const MAX_OBJECTS = 2 ** 17;
/** From the origin, in metres. Light-years are 1e16. */
export const MAX_DISTANCE = 1e15;
/** Of a number per vertex. With the transforms that it may go through it stays within what a scene allows, 1e18. */
export const MAX_VERTEX_VALUE = 1e12;
