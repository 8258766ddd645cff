layout(location = 0) in vec3 position;
layout(location = 2) in uint piece;

uniform vec4 light;  // the direction towards it, in frame coordinates; upwards

// Along the light onto the ground.
void main() {
  vec4 look = look_of(piece);
  vec3 p = placed(position, look, turn_of(piece));
  float height = max(p.y - ground.x, 0.0);
  p -= light.xyz * (height / light.y);
  gl_Position = look.w < 0.0 ? kNowhere : clip_from_frame * vec4(p.x, ground.x, p.z, 1.0);
}
