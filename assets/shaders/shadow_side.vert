layout(location = 0) in vec3 low;  // one edge of the silhouette an instance
layout(location = 1) in vec3 high;
layout(location = 2) in uint piece;
layout(location = 3) in int multiplicity;

uniform int vertices_of_side;  // 6, or 3 where all points at infinity are one
uniform float reach;           // length of the extrusion, frame units; 0: see end_of_push()

invariant gl_Position;
#ifdef SHEET
out float far;
#endif

vec4 pushed(vec3 at) {
  if (reach == 0.0) return end_of_push(at);
  return clip_from_frame * vec4(at + reach * normalize(away_from_light(at)), 1.0);
}

// From the edge u -> v, which has the volume on its left seen from the light, the outward triangles (v, u, u')
// and (v, u', v'), once for each unit of its multiplicity.
void main() {
  vec4 look = look_of(piece);
  int copy = gl_VertexID / vertices_of_side, which = gl_VertexID % vertices_of_side;
  if (look.w < 0.0 || copy >= abs(multiplicity)) {
    gl_Position = kNowhere;
    return;
  }
#ifdef SHEET
  far = which == 2 || which > 3 ? 1.0 : 0.0;
#endif
  vec4 turn = turn_of(piece);
  vec3 u = placed(multiplicity > 0 ? low : high, look, turn), v = placed(multiplicity > 0 ? high : low, look, turn);
  if (which == 0 || which == 3) {
    gl_Position = clip_from_frame * vec4(v, 1.0);
  } else if (which == 1) {
    gl_Position = clip_from_frame * vec4(u, 1.0);
  } else {
    gl_Position = pushed(which == 5 ? v : u);
  }
}
