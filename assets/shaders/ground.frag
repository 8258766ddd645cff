// The ground in parts that are added up: under the sky, and with DIRECT the share of one light.
in vec3 at;

#ifndef DIRECT
uniform sampler2D contact;    // rgb: light from what lies around a place; a: how much of the place is covered
uniform vec4 contact_place;  // corner x, z and inverse size of the contact picture in frame coordinates
#endif

out vec4 pixel;

// Lines at whole numbers of p, one pixel wide, fading where they come closer than some pixels.
float lines(vec2 p, vec2 wide) {
  vec2 off = abs(fract(p - 0.5) - 0.5) / wide;
  vec2 line = clamp(1.3 - off, 0.0, 1.0) * clamp(1.2 - 4.0 * wide, 0.0, 1.0);
  return max(line.x, line.y);
}

// Of the grid, fading out with the distance from the middle, whose square it takes as a share of the radius.
float grid_here(float out2) {
  vec2 p = (at.xz + grid.xy) / grid.z;
  vec2 wide = fwidth(p);
  float line = max(0.42 * lines(p, wide), 0.9 * lines(p * 0.2, wide * 0.2));
  return line * max(1.0 - 8.0 * out2, 0.0);
}

// From 1 to 0 like exp(-x), at a lower cost.
float falling(float x) {
  float t = 1.0 / (1.0 + 0.25 * x), t2 = t * t;
  return t2 * t2;
}

void main() {
  vec2 off = (at.xz - ground.yz) / ground.w;
  float out2 = dot(off, off), line = grid_here(out2), pool = falling(170.0 * out2);
  float gone = max(clamp(2.9 * out2 - 0.02, 0.0, 1.0), 1.0 - falling(0.11 * length(at)));
#ifdef DIRECT
  vec3 bright = max(to_light(at).y, 0.0) * arriving(at);
  vec3 colour = ground_matt.rgb * bright * (0.24 + 0.20 * pool) + line * ground_line.rgb * 0.6 * min(bright.g / 1.6, 1.0);
  pixel = vec4(colour * (1.0 - gone), 0.0);
#else
  vec2 there = (at.xz - contact_place.xy) * contact_place.z;
  vec4 around = texture(contact, there);  // nothing at the border of the picture and beyond
  vec3 colour = sky_light.rgb * (ground_matt.rgb * (0.82 - 0.72 * around.a) + 0.10 * around.rgb);
  colour += ground_matt.rgb * (spot_light(at, vec3(0.0, 1.0, 0.0)) + shaft_light(at));
  colour += line * ground_line.rgb * 0.4;
  pixel = vec4(mix(colour, background(rise_of_sight()), gone), 0.0);
#endif
}
