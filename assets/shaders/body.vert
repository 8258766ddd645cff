layout(location = 0) in vec3 position;
layout(location = 1) in vec4 corner_normal;
layout(location = 2) in uint piece;
layout(location = 3) in float from_rim;  // distance from the nearest rim of a cut, in widths of the glow
layout(location = 4) in uvec2 traits;    // halvings, material
layout(location = 5) in float warmth;    // the temperature at the corner, in units of kWarmest
layout(location = 6) in vec3 warming;    // its gradient, in units of kGradientUnit
layout(location = 7) in float hottest;   // the same of the highest temperature so far
layout(location = 8) in vec3 heating;
layout(location = 9) in float scalar;    // the number of the face, see ScalarField
#ifdef TEXTURED
layout(location = 10) in vec2 corner_uv;

out vec2 uv;
flat out int surface;  // index in "Surfaces"; -1: the paint alone
#endif

const uint kPieceColours = 32u;
const float kDescribed = 2.0;  // added to the gloss of materials that their file describes
layout(std140) uniform Paints {
  vec4 paints[256];            // linear rgb, gloss; see kDescribed
  vec4 pieces[kPieceColours];  // linear rgb; see piece_colours() in body_picture.h
};

uniform mat3 turn;

out vec3 at;
out vec3 normal;
#ifdef WIRE
out vec3 corner;  // 1 at the first, second, third corner
#endif
invariant gl_Position;

flat out vec4 paint;
#ifdef RIM
centroid out float rim;  // 0 at a rim that glows, 1 and more where nothing does
// Two temperatures (K), the current and the highest so far: their linear extrapolations from the corner, as the
// gradient and the value at position 0, and those of the corner itself.
centroid out vec4 now, once;
centroid out vec2 at_corner;
centroid out float noted;  // 1 at corners that know their highest temperature
centroid out vec3 place;
flat out float number_of_face;
const float kWarmest = 65535.0 / 16.0, kGradientUnit = 256.0, kAmbient = 293.0;
#endif

#ifdef RIM
vec4 extrapolated(float temperature, vec3 gradient) {
  vec3 slope = gradient * kGradientUnit;
  return vec4(slope, temperature - dot(slope, position));
}
#endif

vec3 hue_colour(float hue, float saturation, float value) {
  vec3 wheel = clamp(abs(fract(hue + vec3(0.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
  return value * mix(vec3(1.0), wheel, saturation);
}

// Neighbouring numbers get distant hues, for the view of pieces.
vec3 strong_colour(uint piece) {
  float turn_of = fract(float(piece) * 0.61803399);
  float shade = fract(float(piece) * 0.7548777);
  return hue_colour(turn_of, 0.80, 0.40 + 0.25 * shade);
}

// The sets of a separation (see body_picture.cpp), in the colours of the component graph.
const uint kStayed = 65536u;
const vec3 kStayedColour = vec3(0.042, 0.22, 0.60), kCameOffColour = vec3(0.62, 0.50, 0.22);

// From slate over red to yellow, for the sizes of faces.
vec3 level_colour(float t) {
  vec3 colour = mix(vec3(0.055, 0.075, 0.11), vec3(0.36, 0.035, 0.03), smoothstep(0.0, 0.5, t));
  colour = mix(colour, vec3(0.85, 0.26, 0.03), smoothstep(0.4, 0.8, t));
  return mix(colour, vec3(0.95, 0.78, 0.30), smoothstep(0.75, 1.0, t));
}

void main() {
  vec4 look = look_of(piece);
  at = placed(position, look, turn_of(piece));
  gl_ClipDistance[0] = under_section(at);
  gl_Position = look.w < 0.0 ? kNowhere : clip_from_frame * vec4(at, 1.0);
  normal = turned(turn * corner_normal.xyz, turn_of(piece));
#ifdef WIRE
  int which = gl_VertexID % 3;
  corner = vec3(which == 0, which == 1, which == 2);
#endif

  uint number = shown_number(piece, look);
  paint = paints[traits.y];
  bool is_described = paint.a >= kDescribed;
  if (is_described) paint.a -= kDescribed;
#ifdef TEXTURED
  uv = corner_uv;
  surface = is_described && number < kStayed && body_look.y < 0.5 ? int(traits.y) : -1;
#endif
  if (number >= kStayed) {
    paint = vec4(number == kStayed ? kStayedColour : kCameOffColour, 0.25);
  } else if (body_look.y > 1.5) {
    paint = vec4(level_colour(float(traits.x) / max(body_look.x, 1.0)), 0.25);
  } else if (body_look.y > 0.5) {
    paint = number == 0u ? vec4(0.16, 0.17, 0.18, 0.25) : vec4(strong_colour(number), 0.25);
  } else if (number != 0u && body_look.y > -0.5) {
    paint.rgb = pieces[(number - 1u) % kPieceColours].rgb;
  }
#ifdef RIM
  rim = from_rim;
  place = position;
  number_of_face = scalar;
  at_corner = max(vec2(warmth, hottest) * kWarmest, kAmbient);
  now = extrapolated(at_corner.x, warming);
  noted = hottest > 0.0 ? 1.0 : 0.0;
  once = noted * extrapolated(at_corner.y, heating);
#endif
}
