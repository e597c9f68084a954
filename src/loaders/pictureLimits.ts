// How much pictures may ask for; apart from the other limits, because those come with the element.

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
