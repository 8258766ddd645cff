layout(location = 0) in vec3 position;  // in frame coordinates
layout(location = 1) in vec4 fill_colour;

out vec4 colour;

// Nearer to the eye than the surface that it covers.
void main() {
  gl_ClipDistance[0] = dot(section, vec4(position, 1.0));
  gl_Position = clip_from_frame * vec4(nearer(position), 1.0);
  colour = fill_colour;
}
