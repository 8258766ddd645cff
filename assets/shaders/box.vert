layout(location = 0) in vec3 low;   // one box an instance, in the body's float frame
layout(location = 1) in vec3 high;
layout(location = 2) in vec2 style;  // x: 1 the beam was in it, 2 a cut made its face; y: opacity

uniform mat4 frame_from_body;
uniform float half_width;
uniform vec4 hit_colour;
uniform vec4 other_colour;
uniform vec4 edited_colour;

flat out vec4 colour;
flat out float dotted;
noperspective out float along;

// Whether it is seen so small that one of its edges shows where it is.
bool is_speck() {
  float depth = (clip_from_frame * frame_from_body * vec4(mix(low, high, 0.5), 1.0)).w;
  float size = length(mat3(frame_from_body) * (high - low));
  float scale = length(vec3(clip_from_frame[0].y, clip_from_frame[1].y, clip_from_frame[2].y));
  return size * scale * viewport.y < 3.0 * 2.0 * depth;
}

vec3 box_corner(int i) { return mix(low, high, vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1)); }

void main() {
  int edge = gl_VertexID / 6;
  int axis = edge >> 2, other = edge & 3;
  int from = axis == 0 ? other << 1 : axis == 1 ? (other & 1) | (other & 2) << 1 : other;
  vec3 a = (frame_from_body * vec4(box_corner(from), 1.0)).xyz;
  vec3 b = (frame_from_body * vec4(box_corner(from | 1 << axis), 1.0)).xyz;
  gl_ClipDistance[0] = dot(section, vec4(is_line_end(gl_VertexID % 6) ? b : a, 1.0));
  if (edge > 0 && is_speck()) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    return;
  }
  gl_Position = line_vertex(a, b, gl_VertexID % 6, half_width, along);
  colour = style.x > 1.5 ? edited_colour : style.x > 0.5 ? hit_colour : other_colour;
  colour.a *= style.y;
  dotted = 0.0;
}
