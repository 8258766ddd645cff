in vec2 uv;

uniform sampler2D mask;  // 1 on what is outlined
uniform vec4 colour;     // of the screen
uniform float wide;      // pixels

out vec4 pixel;

// How much of a ring of so many pixels lies on the mask at its most.
float most_around(float radius) {
  float most = 0.0;
  for (int i = 0; i < 12; ++i) {
    float turn = float(i) * 0.52359878;
    most = max(most, texture(mask, uv + vec2(cos(turn), sin(turn)) * radius * viewport.zw).a);
  }
  return most;
}

// A line around the mask in its colour, and a dark one around that.
void main() {
  float outside = 1.0 - texture(mask, uv).a;
  float line = most_around(wide) * outside, shade = most_around(wide + 1.3) * outside;
  if (shade <= 0.0) discard;
  pixel = vec4(mix(vec3(0.02, 0.025, 0.03), colour.rgb, line), max(line, 0.6 * shade));
}
