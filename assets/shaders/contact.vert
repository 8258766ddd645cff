layout(location = 0) in vec3 position;
layout(location = 2) in uint piece;

uniform vec4 contact_place;  // corner x, z and inverse size, in frame coordinates

out float height;

// Seen from under the ground.
void main() {
  vec4 look = look_of(piece);
  vec3 p = placed(position, look);
  height = (p.y - ground.x) / max(grid.w, 1e-6);
  vec2 uv = (p.xz - contact_place.xy) * contact_place.z;
  gl_Position = look.w < 0.0 ? kNowhere : vec4(uv * 2.0 - 1.0, clamp(height, 0.0, 1.0), 1.0);
}
