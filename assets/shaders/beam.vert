uniform vec4 beam_from;  // frame coordinates, in front of the eye
uniform vec4 beam_to;
uniform float half_width;  // pixels
uniform vec4 lengths;      // from the emitter to beam_from and to beam_to, over that to the strike

noperspective out float across;  // pixels from the middle of the ribbon
out float along;                  // 0 at the emitter, 1 where it strikes

void main() {
  vec4 a = clip_from_frame * vec4(beam_from.xyz, 1.0);
  vec4 b = clip_from_frame * vec4(beam_to.xyz, 1.0);
  vec2 way = (b.xy / b.w - a.xy / a.w) * viewport.xy;
  vec2 side = normalize(vec2(-way.y, way.x) + vec2(1e-6, 0.0)) * half_width;
  float sign_of = float(gl_VertexID & 1) * 2.0 - 1.0;
  vec4 p = gl_VertexID < 2 ? a : b;
  p.xy += side * sign_of * 2.0 * viewport.zw * p.w;
  across = sign_of * half_width;
  along = gl_VertexID < 2 ? lengths.x : lengths.y;
  gl_Position = p;
}
