layout(location = 0) in vec3 position;
layout(location = 2) in uint piece;

uniform isamplerBuffer signs;  // as in shadow_cap.vert

invariant gl_Position;

out vec3 at;
flat out int sign_of_face;

void main() {
  vec4 look = look_of(piece);
  at = placed(position, look, turn_of(piece));
  gl_ClipDistance[0] = under_section(at);
  gl_Position = look.w < 0.0 ? kNowhere : clip_from_frame * vec4(at, 1.0);
  sign_of_face = texelFetch(signs, gl_VertexID / 3).r;
}
