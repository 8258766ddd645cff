// The ground in parts that are added up: under the sky, and with DIRECT the share of one light.
in vec3 at;

#ifndef DIRECT
uniform sampler2D contact;    // rgb: what lies over a place, times how much of it is covered; a: that
uniform vec4 contact_place;  // corner x, z and inverse size of the contact picture in frame coordinates
#endif

out vec4 pixel;

const vec3 kLine = vec3(0.014, 0.0155, 0.018);
const float kBounceLevel = 4.0;  // of the contact picture, whose pixels are as wide as light bounces

vec3 matt() { return mix(vec3(0.060, 0.061, 0.063), vec3(0.40, 0.41, 0.42), stage.x); }
// Lines are lighter than the ground at dusk and darker by day.
vec3 line_colour() { return mix(kLine, -4.5 * kLine, stage.x); }

// Lines at whole numbers of p, one pixel wide, fading where they come closer than some pixels.
float lines(vec2 p, vec2 wide) {
  vec2 off = abs(fract(p - 0.5) - 0.5) / wide;
  vec2 line = (1.0 - smoothstep(0.35, 1.25, off)) * (1.0 - smoothstep(0.06, 0.35, wide));
  return max(line.x, line.y);
}

// Of the grid, fading out with the distance from the middle.
float grid_here(float out_of_middle) {
  vec2 p = (at.xz + grid.xy) / grid.z;
  vec2 wide = fwidth(p);
  float line = max(0.42 * lines(p, wide), 0.9 * lines(p * 0.2, wide * 0.2));
  return line * max(1.0 - 3.0 * out_of_middle, 0.0);
}

void main() {
  float far = length(at), out_of_middle = length(at.xz - ground.yz) / ground.w;
  float gone = max(smoothstep(0.08, 0.62, out_of_middle), 1.0 - exp(-0.11 * far));
  float line = grid_here(out_of_middle), pool = exp(-170.0 * out_of_middle * out_of_middle);
#ifdef DIRECT
  vec3 bright = max(to_light(at).y, 0.0) * arriving(at);
  vec3 colour = matt() * bright * (0.24 + 0.20 * pool) + line * line_colour() * 0.6 * min(bright.g / 1.6, 1.0);
  pixel = vec4(colour * (1.0 - gone), 0.0);
#else
  vec2 there = (at.xz - contact_place.xy) * contact_place.z;
  bool near = all(lessThan(abs(there - 0.5), vec2(0.5)));
  float covered = near ? textureLod(contact, there, 0.0).a : 0.0;
  vec3 bounced = near ? textureLod(contact, there, kBounceLevel).rgb * (1.0 - covered) : vec3(0.0);
  vec3 colour = matt() * sky_light() * 0.82 * (1.0 - 0.88 * covered) + bounced * sky_light() * 0.10;
  colour += matt() * (spot_light(at, vec3(0.0, 1.0, 0.0)) + shaft_light(at));
  colour += line * line_colour() * 0.4;
  pixel = vec4(mix(colour, background(sight()), gone), 0.0);
#endif
}
