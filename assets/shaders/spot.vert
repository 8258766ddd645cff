uniform vec4 centre;       // frame
uniform float half_width;  // pixels

out vec2 across;

void main() {
  across = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec4 p = clip_from_frame * centre;
  p.xy += across * half_width * 2.0 * viewport.zw * p.w;
  gl_Position = p;
}
