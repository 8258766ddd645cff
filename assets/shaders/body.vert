layout(location = 0) in vec3 position;
layout(location = 1) in vec4 corner_normal;
layout(location = 2) in uint attributes;  // fineness 8, material 8, piece 16

layout(std140) uniform Paints { vec4 paints[256]; };  // linear rgb, gloss

uniform mat3 turn;

out vec3 at;
out vec3 normal;
#ifdef WIRE
out vec3 corner;  // 1 at the first, second, third corner
#endif
invariant gl_Position;

flat out vec4 paint;
out vec4 glow;  // rgb; how much of the paint is burnt away

vec3 hue_colour(float hue, float saturation, float value) {
  vec3 wheel = clamp(abs(fract(hue + vec3(0.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
  return value * mix(vec3(1.0), wheel, saturation);
}

// Neighbouring labels get hues far apart: teal to violet in the picture, all round the wheel where pieces are
// the subject.
vec3 piece_colour(uint piece, bool strong) {
  float turn_of = fract(float(piece) * 0.61803399);
  float shade = fract(float(piece) * 0.7548777);
  if (strong) return hue_colour(turn_of, 0.80, 0.40 + 0.25 * shade);
  return hue_colour(0.40 + 0.40 * turn_of, 0.72, 0.10 + 0.14 * shade);
}

// From dark red over orange to yellow-white, as steel glows.
vec3 ember(float t) {
  vec3 colour = mix(vec3(0.10, 0.004, 0.0), vec3(0.75, 0.07, 0.008), smoothstep(0.0, 0.45, t));
  colour = mix(colour, vec3(2.1, 0.55, 0.06), smoothstep(0.40, 0.75, t));
  return mix(colour, vec3(4.4, 3.0, 1.45), smoothstep(0.75, 1.0, t));
}

void main() {
  vec4 look = look_of(attributes);
  at = placed(position, look);
  gl_Position = look.w < 0.0 ? kNowhere : clip_from_frame * vec4(at, 1.0);
  normal = turn * corner_normal.xyz;
#ifdef WIRE
  int which = gl_VertexID % 3;
  corner = vec3(which == 0, which == 1, which == 2);
#endif

  uint piece = shown_number(attributes, look);
  paint = paints[(attributes >> 8) & 255u];
  if (body_look.z > 0.5) {
    paint = piece == 0u ? vec4(0.16, 0.17, 0.18, 0.25) : vec4(piece_colour(piece, true), 0.25);
  } else if (piece != 0u) {
    paint.rgb = mix(paint.rgb, piece_colour(piece, false), 0.85);
  }
  float t = min(float(attributes & 255u) / (8.0 * max(body_look.x, 1.0)), 1.0);
  float hot = body_look.y * smoothstep(0.70, 1.0, t);
  glow = vec4(ember(hot) * smoothstep(0.0, 0.3, hot), smoothstep(0.0, 0.5, hot));
}
