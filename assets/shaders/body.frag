// What a body shows of itself, in parts that are added up: what it has without the lights (the sky and its
// reflection, the beam's spot, its own glow), with DIRECT the share of one light, and with GLOW its glow alone.
in vec3 at;
in vec3 normal;
#ifdef WIRE
in vec3 corner;
#endif
flat in vec4 paint;
in vec4 glow;

out vec4 pixel;  // linear light; alpha: how much of it may bloom

float gloss_left() { return paint.a * (1.0 - 0.8 * glow.a); }
vec3 skin_left() { return paint.rgb * (1.0 - 0.75 * glow.a); }

#ifdef DIRECT

vec3 outside(vec3 n, vec3 v) {
  vec3 l = to_light(at);
  float gloss = gloss_left(), sharp = exp2(3.0 + 6.5 * gloss);
  float shine = pow(max(dot(n, normalize(l + v)), 0.0), sharp) * (sharp + 8.0) * 0.010 * gloss * step(0.0, dot(n, l));
  return (skin_left() * max(dot(n, l), 0.0) * 0.62 + shine) * arriving(at);
}

vec3 inside(vec3 n) { return vec3(0.088, 0.087, 0.088) * max(dot(n, to_light(at)), 0.0) * 0.25 * arriving(at); }

#else

vec3 outside(vec3 n, vec3 v) {
  float height = clamp((at.y - ground.x) / max(grid.w, 1e-6), 0.0, 1.0);
  float open = 0.42 + 0.58 * smoothstep(0.0, 0.55, height + 0.5 * max(n.y, 0.0));
  vec3 sky = mix(kGroundLight * open, kSkyLight, 0.5 + 0.5 * n.y) * mix(open, 1.0, 0.5);
  float gloss = gloss_left();
  float edge = 1.0 - clamp(dot(n, v), 0.0, 1.0);
  float fresnel = mix(0.035, 0.05, gloss) + (0.25 + 0.55 * gloss) * gloss * edge * edge * edge * edge;
  vec3 mirrored = surroundings(reflect(-v, n)) * fresnel * (0.25 + 1.9 * gloss) * open;
  vec3 rim = kRimColour * edge * edge * edge * max(dot(n, normalize(kRimDirection)), 0.0) * (0.25 + 0.75 * gloss);
  return skin_left() * sky + mirrored + rim;
}

// The bare inside of a sheet.
vec3 inside(vec3 n) {
  return vec3(0.088, 0.087, 0.088) * mix(kGroundLight, kSkyLight * 0.75, 0.5 + 0.5 * n.y);
}

vec3 own_light(vec3 n) {
  vec3 skin = gl_FrontFacing ? paint.rgb : vec3(0.06);
  return (0.25 * skin + 0.05) * spot_light(at, n) + glow.rgb * (gl_FrontFacing ? 1.0 : 0.8);
}

#endif

void main() {
  vec3 v = -normalize(at);
  vec3 n = normalize(gl_FrontFacing ? normal : -normal);
#ifdef GLOW
  vec3 colour = glow.rgb * (gl_FrontFacing ? 1.0 : 0.8);
#else
  vec3 colour = gl_FrontFacing ? outside(n, v) : inside(n);
#ifndef DIRECT
  colour += own_light(n);
#endif
#endif
  if (!gl_FrontFacing) colour *= body_look.w;
#ifdef WIRE
  vec3 wide = fwidth(corner);
  vec3 inner = smoothstep(vec3(0.0), wide * 1.15, corner);
  float line = 1.0 - min(inner.x, min(inner.y, inner.z));
  colour *= 1.0 - 0.65 * line;
#if !defined(DIRECT) && !defined(GLOW)
  colour += vec3(0.20, 0.25, 0.31) * 0.55 * line;
#endif
#endif
#if defined(DIRECT) || defined(GLOW)
  pixel = vec4(colour * clear_air(at), 0.0);
#else
  pixel = vec4(haze(colour, at), clamp(max(glow.r - 0.55, 0.0) * 0.32, 0.0, 1.0));
#endif
}
