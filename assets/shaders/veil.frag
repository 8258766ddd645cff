in vec3 at;
in vec3 corner;

uniform vec4 fill;  // linear rgb; opacity where it is looked at straight on
uniform vec4 edge;  // the same of the edges between faces

out vec4 pixel;

void main() {
  vec3 normal = cross(dFdx(at), dFdy(at));
  float facing = abs(dot(normal, at)) / max(length(normal) * length(at), 1e-20);
  vec3 near = smoothstep(vec3(0.0), fwidth(corner) * 1.2, corner);
  float inside = min(near.x, min(near.y, near.z));
  vec4 colour = mix(edge, vec4(fill.rgb * (0.6 + 0.4 * facing), fill.a), inside);
  float grazing = 1.0 - facing;
  pixel = vec4(finish(colour.rgb), min(colour.a * (1.0 + 2.0 * grazing * grazing), 1.0));
}
