layout(location = 0) in vec3 low;  // one edge of the silhouette an instance
layout(location = 1) in vec3 high;
layout(location = 2) in uint piece;
layout(location = 3) in int multiplicity;

uniform float half_width;  // pixels
uniform float reach;       // 0: the edges; otherwise the lines along which their ends are extruded, frame units
uniform vec4 single_colour;  // by multiplicity
uniform vec4 double_colour;
uniform vec4 many_colour;

flat out vec4 colour;
flat out float dotted;
noperspective out float along;

// Lines of extruded edges that are short in the picture are faint, so that the many of a fine rim make no fog.
void main() {
  vec4 look = look_of(piece);
  vec3 a = placed(low, look, turn_of(piece)), b = placed(high, look, turn_of(piece));
  float short_edge = 1.0;
  if (reach > 0.0) {
    vec4 ca = clip_from_frame * vec4(a, 1.0), cb = clip_from_frame * vec4(b, 1.0);
    float pixels = 0.5 * length((cb.xy / max(cb.w, 1e-5) - ca.xy / max(ca.w, 1e-5)) * viewport.xy);
    short_edge = clamp(pixels / 18.0, 0.04, 1.0);
  }
  if (reach > 0.0) b = a + reach * normalize(away_from_light(a));
  int copies = abs(multiplicity);
  float wide = half_width * (reach > 0.0 ? 1.0 : copies == 1 ? 0.8 : copies == 2 ? 1.2 : 1.9);
  gl_Position = look.w < 0.0 ? kNowhere : line_vertex(a, b, gl_VertexID, wide, along);
  colour = copies == 1 ? single_colour : copies == 2 ? double_colour : many_colour;
  colour.a *= short_edge;
  dotted = 0.0;
}
