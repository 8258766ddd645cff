in float below;

uniform float wide;  // pixels

out vec4 pixel;

const float kLeastSlope = 1e-7;  // of a pixel against the plane: a face in the plane has no line

// A pale line with a dark one beside it, on the faces that the plane cuts.
void main() {
  float slope = fwidth(below), off = below / max(slope, kLeastSlope);
  float line = 1.0 - smoothstep(wide - 0.5, wide + 0.5, off);
  float shade = 1.0 - smoothstep(wide + 0.7, wide + 1.7, off);
  if (shade <= 0.0 || slope < kLeastSlope) discard;
  pixel = vec4(mix(vec3(0.02, 0.025, 0.03), vec3(0.74, 0.87, 1.0), line), max(line, 0.5 * shade));
}
