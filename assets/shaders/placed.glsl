// Positions of the faces of a body: transformed by its placement, then by the look of their piece.
uniform mat4 frame_from_body;
uniform int looks;                  // groups below this have a look
// Two texels a group. The first: xyz: moved by, in frame coordinates; w: -1 hidden, else 1 if selected, plus twice
// (1 + the number that is shown). The second: the quaternion that it is turned by before, about the frame's origin.
uniform samplerBuffer piece_looks;

// Of the group of a face: the label of its piece, or the number of a loose part.
vec4 look_of(uint piece) { return int(piece) < looks ? texelFetch(piece_looks, 2 * int(piece)) : vec4(0.0); }

vec4 turn_of(uint piece) {
  return int(piece) < looks ? texelFetch(piece_looks, 2 * int(piece) + 1) : vec4(0.0, 0.0, 0.0, 1.0);
}

// Exactly v where the quaternion turns nothing.
vec3 turned(vec3 v, vec4 by) { return v + 2.0 * cross(by.xyz, cross(by.xyz, v) + by.w * v); }

bool is_selected(vec4 look) { return look.w > 0.0 && mod(look.w, 2.0) > 0.5; }

// The number that decides the colour of a piece: that of its look, or its label.
uint shown_number(uint piece, vec4 look) { return look.w > 1.5 ? uint(look.w) / 2u - 1u : piece; }

vec3 placed(vec3 position, vec4 look, vec4 turn) {
  return turned((frame_from_body * vec4(position, 1.0)).xyz, turn) + look.xyz;
}

// The depth of a point below the section plane, on the side that is drawn, in frame units.
float under_section(vec3 at) { return dot(section, vec4(at, 1.0)); }

// Outside the view volume: a face with all its corners there is not drawn.
const vec4 kNowhere = vec4(0.0, 0.0, 2.0, 1.0);
