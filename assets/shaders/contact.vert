layout(location = 0) in vec3 position;

uniform mat4 frame_from_body;
uniform vec4 contact_place;  // corner x, z and inverse size, in frame coordinates

out float height;

// Seen from under the ground.
void main() {
  vec3 p = (frame_from_body * vec4(position, 1.0)).xyz;
  height = (p.y - ground.x) / max(grid.w, 1e-6);
  vec2 uv = (p.xz - contact_place.xy) * contact_place.z;
  gl_Position = vec4(uv * 2.0 - 1.0, clamp(height, 0.0, 1.0), 1.0);
}
