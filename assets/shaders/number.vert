layout(location = 0) in vec2 place;  // one digit an instance: its lower left corner, pixels
layout(location = 1) in vec2 style;  // the digit; 1 for a removed face

uniform vec4 cell;   // width and height of a digit with its border, pixels of its bitmap
uniform float zoom;  // pixels of the picture for one of the bitmap

out vec2 in_cell;
flat out vec2 what;

void main() {
  vec2 side = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec2 at = place + side * cell.xy * zoom;
  in_cell = side * cell.xy;
  what = style;
  gl_Position = vec4(at * 2.0 * viewport.zw - 1.0, 0.0, 1.0);
}
