// The light that is added: in frame coordinates with w = 1 its place, with w = 0 the direction towards it.
uniform vec4 light;
uniform vec4 light_colour;  // rgb on a surface that faces it; w: from a point light at a distance of its root

vec3 to_light(vec3 at) { return normalize(light.xyz - at * light.w); }

// The irradiance of a surface that faces it.
vec3 arriving(vec3 at) {
  vec3 way = light.xyz - at;
  return light_colour.rgb * (light.w > 0.0 ? light_colour.w / max(dot(way, way), 1e-12) : 1.0);
}
