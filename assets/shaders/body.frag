// The light from a body, in parts that are added: without defines all but that of the lights (the sky and its
// reflection, the spot of the beam, the body's own glow), with DIRECT that of one light, with GLOW its glow alone.
in vec3 at;
in vec3 normal;
#ifdef WIRE
in vec3 corner;
#endif
flat in vec4 paint;
#ifdef RIM
centroid in float rim;  // samples outside a face must not extrapolate it
centroid in vec4 now, once;  // see body.vert
centroid in vec2 at_corner;
centroid in float noted;
centroid in vec3 place;
flat in float number_of_face;

uniform int heated;  // 1 where the body has temperatures
uniform sampler2D heat_ramps;  // see heat_colours.h
#endif

uniform float terminator;  // sine of the angle between smooth normals and facets

#ifdef TEXTURED
in vec2 uv;
flat in int surface;

uniform int has_images;  // 0 until they are decoded, and for faces without UVs
uniform sampler2DArray colour_images, number_images;

// See SurfaceEntry.
struct Surface {
  vec4 base, emission, traits, layers;
};
layout(std140) uniform Surfaces { Surface surfaces[256]; };
const float kLayerBase = 512.0;  // of two layers in one number; as in surface_textures.cpp

// The material and the values of its maps at this place.
vec4 coat = vec4(0.0);  // colour, gloss
float metal = 0.0, open_to_sky = 1.0;
vec3 emitted = vec3(0.0);
bool is_double_sided = false;
#else
#define coat paint
const float metal = 0.0, open_to_sky = 1.0;
const vec3 emitted = vec3(0.0);
const bool is_double_sided = false;
#endif

out vec4 pixel;  // linear light; alpha: how much of it may bloom

// The effects of heat on a surface.
struct Hot {
  vec3 light;   // that it emits
  vec3 tint;    // colour of the burnt share of its paint
  float burnt;  // that share
};

#ifdef RIM
// From dark red over orange to yellow-white, as steel glows.
vec3 ember(float t) {
  vec3 colour = mix(vec3(0.10, 0.004, 0.0), vec3(0.75, 0.07, 0.008), smoothstep(0.0, 0.45, t));
  colour = mix(colour, vec3(2.1, 0.55, 0.06), smoothstep(0.40, 0.75, t));
  return mix(colour, vec3(4.4, 3.0, 1.45), smoothstep(0.75, 1.0, t));
}

// A row of the table at a fraction of its width.
vec4 ramp(int row, float at) { return texture(heat_ramps, vec2(at, (float(row) + 0.5) / 5.0)); }
const float kHottestOfRows = 4096.0;  // K
const float kAmbient = 293.0;

// The temperature of this point (K). Away from a hot place it falls off less and less steeply, so it is nowhere above
// the straight line between the corners.
float temperature_of(vec4 extrapolated, float straight) {
  return max(min(dot(extrapolated.xyz, place) + extrapolated.w, straight), kAmbient);
}

// Where a body has no temperatures, its rims glow by the distance from them.
Hot heat_of_surface() {
  if (heated != 0) {
    vec4 tint = ramp(1, temperature_of(once / max(noted, 1e-3), at_corner.y) / kHottestOfRows);
    return Hot(ramp(0, temperature_of(now, at_corner.x) / kHottestOfRows).rgb, tint.rgb, tint.a);
  }
  if (rim >= 1.0) return Hot(vec3(0.0), vec3(0.0), 0.0);
  float hot = 1.0 - max(rim, 0.0);
  return Hot(ember(hot) * smoothstep(0.0, 0.5, hot), vec3(0.0), 0.75 * smoothstep(0.0, 0.6, hot));
}

// A row of the table from its first to its last colour.
vec3 scale_colour(int row, float t) { return ramp(row, (clamp(t, 0.0, 1.0) * 511.0 + 0.5) / 512.0).rgb; }

// Whether temperatures or numbers colour the faces.
bool is_mapped() { return body_look.w > 0.0 || face_view.z > 0.0; }

const float kNoNumber = 1e38;  // and above

// The colour of the temperature up to body_look.w, or that of the number of the face; a little darker where a face is
// averted.
vec3 mapped_colour(vec3 n, vec3 v) {
  float shade = 0.75 + 0.25 * abs(dot(n, v));
  if (face_view.z > 0.0) {
    if (number_of_face > kNoNumber) return vec3(0.055, 0.060, 0.068) * shade;
    return scale_colour(2 + int(face_view.z), (number_of_face - face_view.x) / (face_view.y - face_view.x)) * shade;
  }
  return scale_colour(2, (temperature_of(now, at_corner.x) - kAmbient) / (body_look.w - kAmbient)) * shade;
}
#else
Hot heat_of_surface() { return Hot(vec3(0.0), vec3(0.0), 0.0); }
#endif

float gloss_left(Hot hot) { return coat.a * (1.0 - 1.067 * hot.burnt); }
vec3 skin_left(Hot hot) { return mix(coat.rgb, hot.tint, hot.burnt) * (1.0 - 0.6 * metal); }
// The back of a sheet is primed in a grey that has a little of the paint.
vec3 primer(Hot hot) { return mix(mix(vec3(0.15), coat.rgb, 0.25), hot.tint, hot.burnt); }
// Metals tint what they mirror.
vec3 mirror_tint() { return mix(vec3(1.0), 1.5 * coat.rgb, metal); }

// How light that falls on a surface fades out where the smooth normal turns away from it, before the facets do.
float lit(float facing) {
  float from = face_view.w > 0.0 ? 0.0 : terminator;
  return max(facing, 0.0) * smoothstep(from, 2.5 * from + 1e-4, facing);
}

#ifdef DIRECT

vec3 outside(vec3 n, vec3 v, Hot hot) {
  vec3 l = to_light(at);
  float gloss = gloss_left(hot), facing = lit(dot(n, l)), sharp = exp2(3.0 + 6.5 * gloss);
  float shine = pow(max(dot(n, normalize(l + v)), 0.0), sharp) * (sharp + 8.0) * 0.010 * gloss * smoothstep(0.0, 0.1, facing);
  return (skin_left(hot) * facing * 0.62 + shine * mirror_tint()) * arriving(at);
}

vec3 inside(vec3 n, Hot hot) { return primer(hot) * lit(dot(n, to_light(at))) * 0.62 * arriving(at); }

#else

vec3 outside(vec3 n, vec3 v, Hot hot) {
  float height = clamp((at.y - ground.x) / max(grid.w, 1e-6), 0.0, 1.0);
  float open = mix(0.42 + 0.58 * smoothstep(0.0, 0.55, height + 0.5 * max(n.y, 0.0)), 1.0, ground_light.w);
  vec3 sky = mix(ground_light.rgb * open, sky_light.rgb, 0.5 + 0.5 * n.y) * mix(open, 1.0, 0.5);
  float gloss = gloss_left(hot);
  float edge = 1.0 - clamp(dot(n, v), 0.0, 1.0);
  float fresnel = mix(0.035, 0.05, gloss) + (0.25 + 0.55 * gloss) * gloss * edge * edge * edge * edge;
  fresnel += 0.35 * metal;
  vec3 mirrored = surroundings(reflect(-v, n)) * mirror_tint() * fresnel * (0.25 + 1.9 * gloss) * open;
  vec3 rim = kRimColour * edge * edge * edge * max(dot(n, normalize(kRimDirection)), 0.0) * (0.25 + 0.75 * gloss);
  return (skin_left(hot) * sky + mirrored) * open_to_sky + rim;
}

vec3 inside(vec3 n, Hot hot) { return primer(hot) * mix(ground_light.rgb, sky_light.rgb, 0.5 + 0.5 * n.y); }

vec3 own_light(vec3 n, Hot hot) {
  vec3 skin = gl_FrontFacing || is_double_sided ? coat.rgb : primer(hot);
  return emitted + (0.25 * skin + 0.05) * spot_light(at, n) + hot.light * (gl_FrontFacing ? 1.0 : 0.8);
}

#endif

// A colour with the edges of its face over it, at 40 % of a dark line, or a light one where the paint is dark.
vec3 with_wire(vec3 colour, vec3 paint) {
#ifdef WIRE
  vec3 wide = fwidth(corner);
  vec3 inner = smoothstep(vec3(0.0), wide * 1.15, corner);
  float line = 1.0 - min(inner.x, min(inner.y, inner.z));
  colour *= 1.0 - 0.4 * line;
#if !defined(DIRECT) && !defined(GLOW)
  float darkness = 1.0 - smoothstep(0.02, 0.03, dot(paint, vec3(0.2126, 0.7152, 0.0722)));
  colour += vec3(0.10, 0.125, 0.155) * 0.4 * darkness * line;
#endif
#endif
  return colour;
}

// Towards the eye.
vec3 shading_normal() {
  vec3 smooth_one = normalize(gl_FrontFacing ? normal : -normal);
  if (face_view.w == 0.0) return smooth_one;
  vec3 across = cross(dFdx(at), dFdy(at));
  float size = length(across);
  return size > 0.0 ? across / size : smooth_one;
}

#ifdef TEXTURED
vec4 number_map(float layer, vec4 otherwise) {
  return layer > 0.5 && has_images != 0 ? texture(number_images, vec3(uv, layer - 1.0)) : otherwise;
}
vec4 colour_map(float layer) {
  return layer > 0.5 && has_images != 0 ? texture(colour_images, vec3(uv, layer - 1.0)) : vec4(1.0);
}

// Turns a normal of a map from the frame of the UVs (C. Schueler: Normal mapping without precomputed tangents,
// 2013).
vec3 bent(vec3 n, vec3 by) {
  vec3 p = cross(dFdy(at), n), q = cross(n, dFdx(at));
  vec2 uv_x = dFdx(uv), uv_y = dFdy(uv);
  vec3 t = p * uv_x.x + q * uv_y.x, b = p * uv_x.y + q * uv_y.y;
  float size = max(dot(t, t), dot(b, b));
  return size > 0.0 ? normalize((t * by.x - b * by.y) * inversesqrt(size) + n * by.z) : n;
}

// A pattern of 16 thresholds stands for partial opacity.
float threshold_here() {
  const float kOrder[16] = float[16](0.0, 8.0, 2.0, 10.0, 12.0, 4.0, 14.0, 6.0, 3.0, 11.0, 1.0, 9.0, 15.0, 7.0, 13.0, 5.0);
  ivec2 place = ivec2(gl_FragCoord.xy) & 3;
  return (kOrder[4 * place.y + place.x] + 0.5) / 16.0;
}

// Evaluates the maps and returns the normal. Discards what is transparent.
vec3 read_surface(vec3 n) {
  coat = paint;
  if (surface < 0 || surfaces[surface].emission.w == 0.0) return n;
  Surface s = surfaces[surface];
  vec2 first = mod(s.layers.xy, kLayerBase), second = floor(s.layers.xy / kLayerBase);
  float emission = mod(s.layers.z, kLayerBase);
  is_double_sided = s.layers.z > kLayerBase - 0.5;
  vec4 base = s.base * colour_map(first.x);
  vec4 rough = number_map(first.y, vec4(1.0));
  vec4 normals = number_map(second.x, vec4(0.5, 0.5, 1.0, 1.0));
  open_to_sky = mix(1.0, number_map(second.y, vec4(1.0)).r, s.traits.w);
  emitted = s.emission.rgb * colour_map(emission).rgb;
  metal = s.traits.x * rough.b;
  coat = vec4(base.rgb, 1.0 - s.traits.y * rough.g);
  float needed = s.layers.w < -1.5 ? threshold_here() : s.layers.w;
  vec3 by = normals.xyz * 2.0 - 1.0;
  vec3 turned_normal = second.x > 0.5 ? bent(n, vec3(by.xy * s.traits.z, by.z)) : n;
  if (base.a < needed) discard;
  return turned_normal;
}
#endif

void main() {
  vec3 v = -normalize(at);
  vec3 n = shading_normal();
#ifdef TEXTURED
  n = read_surface(n);
#endif
#ifdef RIM
  if (is_mapped()) {
#if defined(DIRECT) || defined(GLOW)
    pixel = vec4(0.0);
#else
    vec3 mapped = mapped_colour(n, v);
    pixel = vec4(with_wire(mapped, mapped), 0.0);
#endif
    return;
  }
#endif
  Hot hot = heat_of_surface();
#ifdef GLOW
  vec3 colour = hot.light * (gl_FrontFacing ? 1.0 : 0.8);
#else
  vec3 colour = gl_FrontFacing || is_double_sided ? outside(n, v, hot) : inside(n, hot);
#ifndef DIRECT
  colour += own_light(n, hot);
#endif
#endif
  if (!gl_FrontFacing) colour *= body_look.z;
  colour = with_wire(colour, skin_left(hot));
#if defined(DIRECT) || defined(GLOW)
  pixel = vec4(colour * clear_air(at), 0.0);
#else
  pixel = vec4(haze(colour, at), clamp(max(hot.light.r - 0.55, 0.0) * 0.32, 0.0, 1.0));
#endif
}
