layout(location = 0) in vec3 position;
layout(location = 2) in uint piece;
layout(location = 4) in uvec2 traits;  // halvings, material

layout(std140) uniform Paints { vec4 paints[256]; };  // linear rgb, gloss

uniform vec4 contact_place;  // corner x, z and inverse size, in frame coordinates

out float height;
flat out vec3 colour;

// Seen from under the ground.
void main() {
  vec4 look = look_of(piece);
  vec3 p = placed(position, look, turn_of(piece));
  height = (p.y - ground.x) / max(grid.w, 1e-6);
  colour = paints[traits.y].rgb;
  vec2 uv = (p.xz - contact_place.xy) * contact_place.z;
  gl_Position = look.w < 0.0 ? kNowhere : vec4(uv * 2.0 - 1.0, clamp(height, 0.0, 1.0), 1.0);
}
