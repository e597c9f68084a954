// How much a file may ask for. A few bytes can claim anything, so this is checked before memory is taken.

/** Of a file that is fetched or dropped. A model of eight million triangles has 300 MB, and browsers give little more in one piece. */
export const MAX_FILE_BYTES = 2 ** 29;
/** After instancing. A million is a large model on the web; these take half a gigabyte. */
export const MAX_TRIANGLES = 2 ** 23;
/** After instancing. */
export const MAX_VERTICES = 2 ** 24;
/** Of a picture before it is made smaller: 16384 × 16384, of which the texels are a GiB. */
export const MAX_PICTURE_TEXELS = 2 ** 28;
/** What a scene allows of a texture's width and height. Larger pictures are made smaller. */
export const MAX_TEXTURE_SIDE = 16384;
/** Of all pictures together before they are made smaller: 256 of 4096 × 4096. To decode them takes minutes. */
export const MAX_DECODED_TEXELS = 2 ** 32;
/** Of all textures together, four per texel. Memory holds them twice: here and on the graphics card. */
export const MAX_TEXEL_BYTES = 2 ** 29;
/** What every WebGPU device can hold in one buffer. */
export const CERTAIN_TEXEL_BYTES = 2 ** 27;
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
