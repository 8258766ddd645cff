in vec2 uv;
out vec4 pixel;

void main() {
  vec2 side = uv * 2.0 - 1.0;
  vec3 direction = normalize(camera_forward.xyz + side.x * camera_right.w * camera_right.xyz +
                             side.y * camera_up.w * camera_up.xyz);
  pixel = vec4(background(direction), 0.0);
}
