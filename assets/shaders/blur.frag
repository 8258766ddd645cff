in vec2 uv;

uniform sampler2D picture;
uniform vec4 stride;  // of one tap in texture coordinates

out vec4 pixel;

void main() {
  vec4 sum = 0.1964825 * texture(picture, uv);
  sum += 0.2969069 * (texture(picture, uv + 1.41176 * stride.xy) + texture(picture, uv - 1.41176 * stride.xy));
  sum += 0.0944704 * (texture(picture, uv + 3.29412 * stride.xy) + texture(picture, uv - 3.29412 * stride.xy));
  sum += 0.0103814 * (texture(picture, uv + 5.17647 * stride.xy) + texture(picture, uv - 5.17647 * stride.xy));
  pixel = sum;
}
