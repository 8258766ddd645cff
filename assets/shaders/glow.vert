uniform sampler2D far_glow;  // a sixteenth of the picture's size: one of its pixels a tile

out vec2 uv;

// Tiles of the picture, two triangles each, in rows from below; those that nothing shines near are not drawn.
void main() {
  ivec2 size = textureSize(far_glow, 0);
  int tile = gl_VertexID / 6, corner = gl_VertexID % 6;
  ivec2 at = ivec2(tile % size.x, tile / size.x);
  vec3 most = vec3(0.0);
  for (int i = 0; i < 9; ++i) {
    ivec2 beside = clamp(at + ivec2(i % 3, i / 3) - 1, ivec2(0), size - 1);
    most = max(most, texelFetch(far_glow, beside, 0).rgb);
  }
  bool right = corner == 1 || corner == 2 || corner == 4, above = corner == 2 || corner == 4 || corner == 5;
  uv = (vec2(at) + vec2(right, above)) / vec2(size);
  bool shines = max(most.r, max(most.g, most.b)) > 0.0;
  gl_Position = shines ? vec4(uv * 2.0 - 1.0, 0.0, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
