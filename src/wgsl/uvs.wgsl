// Texture coordinates at a point of a mesh: of the first set or, where textures have places of their own, of both sets.

@if(!UV_TRANSFORMS) alias Uvs = vec2f;
@if(UV_TRANSFORMS) alias Uvs = vec4f;
