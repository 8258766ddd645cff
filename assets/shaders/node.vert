layout(location = 0) in vec3 middle;  // one disc an instance, in frame coordinates
layout(location = 1) in float radius;  // pixels, in a picture of usual height
layout(location = 2) in vec4 disc_colour;

out vec2 in_disc;
flat out float pixels;
flat out vec4 colour;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  pixels = radius * line_scale();
  gl_ClipDistance[0] = dot(section, vec4(middle, 1.0));
  vec4 at = clip_from_frame * vec4(nearer(middle), 1.0);
  at.xy += corner * (pixels + 1.0) * 2.0 * viewport.zw * at.w;
  in_disc = corner * (pixels + 1.0);
  colour = disc_colour;
  gl_Position = at.w > 0.0 ? at : vec4(0.0, 0.0, 2.0, 1.0);
}
