in vec2 across;
in float strength;
out vec4 pixel;

void main() {
  float r = dot(across, across);
  pixel = vec4(mix(sky_light.rgb, vec3(0.32, 0.33, 0.35), 0.7), strength * exp(-3.5 * r) * (1.0 - smoothstep(0.6, 1.0, r)));
}
