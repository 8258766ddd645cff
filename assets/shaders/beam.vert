// A ribbon along a segment of the picture: a cap before it, the segment, a cap behind it.
uniform vec4 ends;           // pixels: xy where it begins, zw where it ends
uniform vec4 core;           // z: the core's largest width in pixels, w: half width of the ribbon over that of the core

void main() {
  vec2 way = ends.zw - ends.xy;
  float distance_between = length(way);
  vec2 along = distance_between > 1e-3 ? way / distance_between : vec2(1.0, 0.0);
  float half_width = core.z * core.w;
  int pair = gl_VertexID >> 1;
  bool second = pair >= 2;
  vec2 p = second ? ends.zw : ends.xy;
  if (pair == 0) p -= along * half_width;
  if (pair == 3) p += along * half_width;
  p += vec2(-along.y, along.x) * half_width * (float(gl_VertexID & 1) * 2.0 - 1.0);
  gl_Position = vec4(p * 2.0 * viewport.zw - 1.0, 0.0, 1.0);
}
