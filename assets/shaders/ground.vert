out vec3 at;

invariant gl_Position;

void main() {
  vec2 side = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  at = vec3(ground.y + side.x * ground.w, ground.x, ground.z + side.y * ground.w);
  gl_Position = clip_from_frame * vec4(at, 1.0);
}
