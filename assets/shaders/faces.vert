layout(location = 0) in vec3 position;
layout(location = 2) in uint piece;

uniform int first_slot;  // of vertex 0
uniform int body;        // 1 .. 127
uniform int only;        // 0: all, 1: selected pieces, 2: hidden or displaced pieces, at their positions in the world

invariant gl_Position;

flat out vec4 mark;  // slot of the face and number of the body, in the bytes of a pixel

void main() {
  vec4 look = look_of(piece);
  vec4 turn = turn_of(piece);
  bool away = look.w < 0.0 || look.xyz != vec3(0.0) || turn.xyz != vec3(0.0);
  bool drawn = only == 0 ? look.w >= 0.0 : only == 1 ? is_selected(look) : away;
  vec3 at = only == 2 ? placed(position, vec4(0.0), vec4(0.0, 0.0, 0.0, 1.0)) : placed(position, look, turn);
  gl_ClipDistance[0] = under_section(at);
  gl_Position = drawn ? clip_from_frame * vec4(at, 1.0) : kNowhere;
  int slot = first_slot + gl_VertexID / 3;
  mark = vec4(slot & 255, slot >> 8 & 255, slot >> 16 & 255, body) / 255.0;
}
