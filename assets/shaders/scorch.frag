uniform int glow;  // 0: what the surface keeps of its light, 1: what the heat adds

in vec2 across;
in float heat;
out vec4 pixel;

void main() {
  float r = length(across);
  float burnt = 1.0 - smoothstep(0.25, 1.0, r), core = 1.0 - smoothstep(0.0, 0.55, r);
  if (glow == 0) {
    pixel = vec4(vec3(1.0 - 0.78 * burnt), 1.0);
  } else {
    float hot = core * heat;
    pixel = vec4(mix(vec3(0.6, 0.08, 0.01), vec3(1.0, 0.72, 0.38), hot) * hot, 0.7 * hot);
  }
}
