layout(location = 0) in vec3 from;  // one line an instance, in frame coordinates
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 line_colour;

uniform float half_width;
uniform vec4 shade;  // drawn in place of the colour, in proportion to w

flat out vec4 colour;
flat out float dotted;
noperspective out float along;

void main() {
  gl_ClipDistance[0] = dot(section, vec4(from, 1.0)) + dot(section, vec4(to, 1.0));
  gl_Position = line_vertex(from, to, gl_VertexID, half_width, along);
  colour = vec4(mix(line_colour.rgb, shade.rgb, shade.w), line_colour.a);
  dotted = 0.0;
}
