uniform float strength;  // of the light, 1 for a beam that is on

in vec2 across;
out vec4 pixel;

void main() {
  float r = length(across);
  float core = exp(-r * r * 240.0);
  float glow = exp(-r * r * 26.0) * 0.55 + exp(-r * 6.0) * 0.20;
  float fade = strength * (1.0 - smoothstep(0.7, 1.0, r));
  vec3 colour = core * vec3(1.3, 1.25, 1.15) + glow * vec3(1.0, 0.62, 0.30);
  pixel = vec4(colour * fade, (core + 0.5 * glow) * fade);
}
