// Ambient light and reflections of the workshop at dusk or by day, and tone mapping to eight bits. Linear light.

const vec3 kRimDirection = vec3(0.62, 0.35, -0.70);
const vec3 kRimColour = vec3(0.34, 0.42, 0.55);

// The height of the unit vector along the ray of this pixel.
float rise_of_sight() {
  vec2 side = (gl_FragCoord.xy * viewport.zw * 2.0 - 1.0) * vec2(camera_right.w, camera_up.w);
  return (camera_forward.y + side.x * camera_right.y + side.y * camera_up.y) * inversesqrt(1.0 + dot(side, side));
}

// The background at this height of a unit vector: a band of light along the horizon under a darker sky. Far ground
// has the colour of the sky at the same height above the horizon.
vec3 background(float rise) {
  float up = abs(max(rise, -0.3));
  float low = exp(-3.25 * up), low2 = low * low;
  return mix(sky_high.rgb, sky_low.rgb, low) + sky_band.rgb * (low2 * low2);
}

// The surroundings reflected by polished paint: the sky, a dark ground, and a broad soft light around the key light.
vec3 surroundings(vec3 direction) {
  float up = direction.y;
  vec3 sky = mix(vec3(0.36, 0.42, 0.50), vec3(0.10, 0.13, 0.19), clamp(up * 1.3, 0.0, 1.0));
  vec3 seen = mix(vec3(0.035, 0.034, 0.034), sky, smoothstep(-0.12, 0.10, up));
  float box = smoothstep(0.55, 0.97, dot(direction, key_light.xyz));
  return seen + box * vec3(1.5, 1.45, 1.35);
}

// The light of the spot where the beam strikes; nothing in programs without SPOT.
vec3 spot_light(vec3 at, vec3 normal) {
#ifndef SPOT
  return vec3(0.0);
#endif
  vec3 to = spot.xyz - at;
  float r2 = dot(to, to) / (spot.w * spot.w) + 0.02;
  float facing = 0.35 + 0.65 * abs(dot(normalize(to + normal * spot.w * 0.05), normal));
  return spot_colour.rgb * facing * exp(-1.6 * sqrt(r2)) / (0.25 + 6.0 * r2);
}

// The light of the shaft, from where it is emitted to where it strikes; nothing in programs without SPOT.
vec3 shaft_light(vec3 at) {
#ifndef SPOT
  return vec3(0.0);
#endif
  vec3 way = spot.xyz - beam.xyz;
  float t = clamp(dot(at - beam.xyz, way) / max(dot(way, way), 1e-12), 0.0, 1.0);
  float r = distance(at, beam.xyz + t * way);
  return spot_colour.rgb * 0.30 * spot.w / (r + spot.w) * exp(-4.0 * r);
}

vec3 filmic(vec3 x) {  // K. Narkowicz, ACES filmic tone mapping curve, 2016
  x = min(x, vec3(60000.0));  // right next to a bright light, the sum of half floats may be infinite
  return clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

// To the screen's curve, with a little noise so that dark slopes do not band.
vec3 finish(vec3 linear) {
  // The sRGB curve by square roots (within 0.4 % of white), which cost a processor far less than pow.
  vec3 x = filmic(linear), s1 = sqrt(x), s2 = sqrt(s1), s3 = sqrt(s2);
  vec3 screen = 0.662002687 * s1 + 0.684122060 * s2 - 0.323583601 * s3 - 0.0225411470 * x;
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  return screen + (noise - 0.5) / 255.0;
}

// The share of light from a place that the haze transmits; and a colour behind haze, with the light that it adds.
float clear_air(vec3 at) { return exp(-0.028 * length(at)); }
vec3 haze(vec3 colour, vec3 at) {
  return mix(background(at.y / max(length(at), 1e-6)), colour, clear_air(at));
}
