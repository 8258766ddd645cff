in vec3 at;

uniform float shaded;  // 1 where the key light does not reach
uniform sampler2D contact;
uniform vec4 contact_place;  // corner x, z and inverse size of the contact picture in frame coordinates

out vec4 pixel;

// Lines at whole numbers of p, one pixel wide, fading where they come closer than some pixels.
float lines(vec2 p, vec2 wide) {
  vec2 off = abs(fract(p - 0.5) - 0.5) / wide;
  vec2 line = (1.0 - smoothstep(0.35, 1.25, off)) * (1.0 - smoothstep(0.06, 0.35, wide));
  return max(line.x, line.y);
}

void main() {
  float far = length(at), out_of_middle = length(at.xz - ground.yz) / ground.w;
  vec3 direction = at / max(far, 1e-6);
  vec2 there = (at.xz - contact_place.xy) * contact_place.z;
  float covered = all(lessThan(abs(there - 0.5), vec2(0.5))) ? texture(contact, there).r : 0.0;

  vec3 matt = vec3(0.062, 0.063, 0.065);
  vec3 light = kSkyLight * 0.82 * (1.0 - 0.88 * covered) + (1.0 - shaded) * key_light.y * kKeyColour * 0.30;
  vec3 colour = matt * light + matt * spot_light(at, vec3(0.0, 1.0, 0.0));

  vec2 p = (at.xz + grid.xy) / grid.z;
  vec2 wide = fwidth(p);
  float line = max(0.42 * lines(p, wide), 0.9 * lines(p * 0.2, wide * 0.2));
  colour += line * vec3(0.014, 0.0155, 0.018) * (1.0 - 0.6 * shaded) * max(1.0 - 3.0 * out_of_middle, 0.0);

  float gone = max(smoothstep(0.18, 1.0, out_of_middle), 1.0 - 1.0 / (1.0 + 0.05 * far));
  pixel = vec4(finish(mix(colour, background(direction), gone)), 0.0);
}
