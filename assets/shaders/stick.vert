layout(location = 0) in vec3 from;  // one line an instance, in the body's float frame
layout(location = 1) in vec3 to;

uniform mat4 frame_from_body;
uniform float half_width;
uniform vec4 hit_colour;

flat out vec4 colour;
flat out float dotted;
noperspective out float along;

void main() {
  vec3 a = (frame_from_body * vec4(from, 1.0)).xyz;
  vec3 b = (frame_from_body * vec4(to, 1.0)).xyz;
  gl_ClipDistance[0] = dot(section, vec4(a, 1.0));
  gl_Position = line_vertex(a, b, gl_VertexID, half_width, along);
  colour = hit_colour;
  dotted = 0.0;
}
