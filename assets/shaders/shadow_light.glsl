// The light that casts, in frame coordinates: w = 1 and its place, or w = 0 and the direction towards it.
uniform vec4 light;

// Where the light pushes a point in the end, as a direction.
vec3 away_from_light(vec3 at) { return at * light.w - light.xyz; }
