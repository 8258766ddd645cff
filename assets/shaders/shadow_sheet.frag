in float far;  // 0 at the silhouette, 1 where the sheet ends

uniform vec4 front;  // of the sides that are seen from outside the volume
uniform vec4 back;

out vec4 pixel;

void main() {
  vec4 colour = gl_FrontFacing ? front : back;
  pixel = vec4(colour.rgb, colour.a * (1.0 - smoothstep(0.25, 1.0, far)));
}
