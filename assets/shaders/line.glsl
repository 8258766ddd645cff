// Lines are wider in proportion in pictures that are higher than this.
float line_scale() { return max(1.0, viewport.y / 900.0); }

// Pulled along the ray of the picture by a share of its distance.
vec3 nearer(vec3 at) {
  vec3 way = at + camera_forward.xyz * camera_forward.w;
  return at - way * (0.0015 * length(at) / max(length(way), 1e-6));
}

// Whether a vertex of line_vertex() is at the end of the line, not at its beginning.
bool is_line_end(int vertex) { return vertex == 1 || vertex == 2 || vertex == 4; }

// A line of some pixels' width from a to b in frame coordinates as two triangles: which of six vertices this is.
// Pulled towards the eye a little, so that lines on a surface show. Returns pixels along the line in `along`, in a picture of usual height.
vec4 line_vertex(vec3 a, vec3 b, int vertex, float half_width, out float along) {
  vec4 ca = clip_from_frame * vec4(nearer(a), 1.0), cb = clip_from_frame * vec4(nearer(b), 1.0);
  const float near = 1e-5;
  if (ca.w < near && cb.w < near) return vec4(0.0, 0.0, 2.0, 1.0);
  if (ca.w < near) ca = mix(cb, ca, (cb.w - near) / (cb.w - ca.w));
  if (cb.w < near) cb = mix(ca, cb, (ca.w - near) / (ca.w - cb.w));
  vec2 way = (cb.xy / cb.w - ca.xy / ca.w) * viewport.xy * 0.5;
  float far = length(way);
  vec2 side = far > 1e-6 ? vec2(-way.y, way.x) / far : vec2(0.0, 1.0);
  bool end = is_line_end(vertex);
  bool left = vertex == 2 || vertex == 4 || vertex == 5;
  vec4 p = end ? cb : ca;
  p.xy += side * (left ? half_width : -half_width) * line_scale() * 2.0 * viewport.zw * p.w;
  along = end ? far / line_scale() : 0.0;
  return p;
}
