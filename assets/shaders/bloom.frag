in vec2 uv;

uniform sampler2D picture;
uniform sampler2D near_glow;
uniform sampler2D far_glow;

out vec4 pixel;

void main() {
  vec3 seen = texture(picture, uv).rgb;
  vec3 glow = texture(near_glow, uv).rgb * vec3(0.75, 0.62, 0.50) + texture(far_glow, uv).rgb * vec3(0.75, 0.42, 0.22);
  pixel = vec4(seen + glow * (1.0 - seen * 0.75), 1.0);
}
