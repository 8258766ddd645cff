layout(location = 0) in vec3 position;
layout(location = 2) in uint piece;

uniform isamplerBuffer signs;  // of the faces of this chunk: 1: faces the light, -1: faces away, 0: casts no shadow
uniform int wanted;            // faces of this sign are drawn
uniform int under;             // 1: the kept side of the section plane is drawn, -1: the other side
uniform int pushed;            // 0: at their positions, 1: extruded away from the light, see end_of_push()

invariant gl_Position;

// At their positions these must have exactly the pixels and depths of the frame: the same expression, and the same
// corners in the same order.
void main() {
  vec4 look = look_of(piece);
  vec3 at = placed(position, look, turn_of(piece));
  gl_ClipDistance[0] = pushed == 0 ? under_section(at) * float(under) : 1.0;
  if (look.w < 0.0 || texelFetch(signs, gl_VertexID / 3).r != wanted) {
    gl_Position = kNowhere;
  } else if (pushed == 0) {
    gl_Position = clip_from_frame * vec4(at, 1.0);
  } else {
    gl_Position = end_of_push(at);
  }
}
