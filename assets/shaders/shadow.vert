layout(location = 0) in vec3 position;

uniform mat4 frame_from_body;

// Along the key light onto the ground.
void main() {
  vec3 p = (frame_from_body * vec4(position, 1.0)).xyz;
  float height = max(p.y - ground.x, 0.0);
  p -= key_light.xyz * (height / key_light.y);
  gl_Position = clip_from_frame * vec4(p.x, ground.x, p.z, 1.0);
}
