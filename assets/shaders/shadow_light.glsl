// The light that casts, in frame coordinates: w = 1 and its place, or w = 0 and the direction towards it.
uniform vec4 light;

uniform int has_floor;       // 1: volumes end at a floor, 0: they extend to infinity
uniform float floor_height;  // in frame coordinates

// The direction in which a point is extruded away from the light.
vec3 away_from_light(vec3 at) { return at * light.w - light.xyz; }

// The end of the extrusion of a point, in clip coordinates: at infinity or, for a directional light from above, on
// the floor. Points below the floor stay.
vec4 end_of_push(vec3 at) {
  if (has_floor == 0) return clip_from_frame * vec4(away_from_light(at), 0.0);
  return clip_from_frame * vec4(at - light.xyz * max((at.y - floor_height) / light.y, 0.0), 1.0);
}
