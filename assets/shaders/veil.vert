layout(location = 0) in vec3 position;
layout(location = 1) in uint base;

uniform mat4 frame_from_body;
uniform int body;

out vec3 at;
out vec3 corner;     // 1 at the first, second, third corner
flat out vec4 mark;  // as in faces.vert; the highest bit marks a removed face

void main() {
  at = (frame_from_body * vec4(position, 1.0)).xyz;
  gl_ClipDistance[0] = dot(section, vec4(at, 1.0));
  gl_Position = clip_from_frame * vec4(at, 1.0);
  int which = gl_VertexID % 3;
  corner = vec3(which == 0, which == 1, which == 2);
  mark = vec4(base & 255u, base >> 8 & 255u, base >> 16 & 255u, uint(body) | 128u) / 255.0;
}
