layout(location = 0) in vec3 position;
layout(location = 2) in uint piece;

invariant gl_Position;

out float below;  // the section plane, in frame units

void main() {
  vec4 look = look_of(piece);
  vec3 at = placed(position, look, turn_of(piece));
  below = under_section(at);
  gl_ClipDistance[0] = below;
  gl_Position = look.w < 0.0 ? kNowhere : clip_from_frame * vec4(at, 1.0);
}
