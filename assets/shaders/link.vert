layout(location = 0) in vec3 from;  // one line an instance, in frame coordinates
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 line_colour;

uniform float half_width;
uniform int in_part;  // 1: a section plane leaves a part of a line, else all or nothing
uniform vec4 shade;  // drawn in place of the colour, in proportion to w

flat out vec4 colour;
flat out float dotted;
noperspective out float along;

void main() {
  gl_Position = line_vertex(from, to, gl_VertexID, half_width, along);
  vec2 heights = vec2(dot(section, vec4(from, 1.0)), dot(section, vec4(to, 1.0)));
  gl_ClipDistance[0] = in_part == 0 ? heights.x + heights.y : is_line_end(gl_VertexID) ? heights.y : heights.x;
  colour = vec4(mix(line_colour.rgb, shade.rgb, shade.w), line_colour.a);
  dotted = 0.0;
}
