// Where the faces of a body are drawn: where it stands, and where the look of their piece moves them.
uniform mat4 frame_from_body;
uniform int looks;                  // pieces below this have a look
uniform samplerBuffer piece_looks;  // xyz: moved by, in frame coordinates; w: -1 hidden, 0 plain, 1 selected

// Of the piece in a face's attributes (fineness 8, material 8, piece 16).
vec4 look_of(uint attributes) {
  int piece = int(attributes >> 16);
  return piece < looks ? texelFetch(piece_looks, piece) : vec4(0.0);
}

vec3 placed(vec3 position, vec4 look) { return (frame_from_body * vec4(position, 1.0)).xyz + look.xyz; }

// Beyond what is seen; a face with all its corners there is not drawn.
const vec4 kNowhere = vec4(0.0, 0.0, 2.0, 1.0);
