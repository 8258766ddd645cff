in vec2 in_cell;
flat in vec2 what;

uniform sampler2D digits;  // the bitmaps side by side, each with an empty border of one
uniform vec4 cell;

out vec4 pixel;

float ink(ivec2 p) {
  ivec2 size = ivec2(cell.xy);
  bool within = all(greaterThanEqual(p, ivec2(0))) && all(lessThan(p, size));
  return within ? texelFetch(digits, ivec2(p.x + int(what.x) * size.x, p.y), 0).r : 0.0;
}

void main() {
  ivec2 p = ivec2(floor(in_cell));
  float here = ink(p), around = 0.0;
  for (int i = 0; i < 9; ++i) around = max(around, ink(p + ivec2(i % 3 - 1, i / 3 - 1)));
  if (around == 0.0) discard;
  vec3 colour = what.y > 0.5 ? vec3(1.0, 0.86, 0.82) : vec3(0.95, 0.96, 0.97);
  vec3 dark = what.y > 0.5 ? vec3(0.22, 0.02, 0.02) : vec3(0.04, 0.05, 0.06);
  pixel = here > 0.5 ? vec4(colour, 1.0) : vec4(dark, 0.8);
}
