in vec2 uv;

uniform sampler2D picture;  // rgb: what lies over a place, times how much of it is covered; a: that

out vec4 pixel;  // rgb: the light that what lies around throws on the place; a: how much of the place is covered

const float kBounceLevel = 4.0;  // of the picture, whose pixels are as wide as light bounces

void main() {
  float covered = textureLod(picture, uv, 0.0).a;
  vec2 inside = smoothstep(vec2(0.0), vec2(0.03), min(uv, 1.0 - uv));
  pixel = vec4(textureLod(picture, uv, kBounceLevel).rgb * (1.0 - covered), covered) * inside.x * inside.y;
}
