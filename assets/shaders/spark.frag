in vec2 across;
in float strength;
out vec4 pixel;

void main() {
  float core = (1.0 - smoothstep(0.15, 1.0, abs(across.x))) * (1.0 - smoothstep(0.5, 1.0, abs(across.y)));
  vec3 colour = mix(vec3(0.75, 0.12, 0.02), mix(vec3(1.0, 0.50, 0.12), vec3(1.0, 0.93, 0.78), strength), min(1.0, 2.0 * strength));
  float shine = core * min(1.0, 3.0 * strength);
  pixel = vec4(colour * shine, 0.8 * shine);
}
