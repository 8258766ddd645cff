in vec3 at;
flat in int sign_of_face;

uniform vec4 facing_colour;  // of the screen; polygons that face the light
uniform vec4 averted_colour;
uniform vec4 neither_colour;

out vec4 pixel;

// A little relief, lit from the eye.
void main() {
  vec3 normal = cross(dFdx(at), dFdy(at));
  float relief = 0.45 + 0.55 * abs(dot(normal, at)) / max(length(normal) * length(at), 1e-20);
  vec4 colour = sign_of_face > 0 ? facing_colour : sign_of_face < 0 ? averted_colour : neither_colour;
  pixel = vec4(colour.rgb * relief, 0.0);
}
