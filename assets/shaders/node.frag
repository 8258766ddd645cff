in vec2 in_disc;
flat in float pixels;
flat in vec4 colour;

out vec4 pixel;

void main() {
  float from_rim = pixels - length(in_disc);
  float cover = clamp(from_rim + 0.5, 0.0, 1.0);
  if (cover == 0.0) discard;
  float rim = 1.0 - smoothstep(0.6, 1.6, from_rim * 4.0 / max(pixels, 2.0));
  pixel = vec4(mix(colour.rgb, vec3(0.03, 0.04, 0.05), 0.8 * rim), colour.a * cover);
}
