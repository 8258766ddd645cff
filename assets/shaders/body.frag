in vec3 at;
in vec3 normal;
#ifdef WIRE
in vec3 corner;
#endif
flat in vec4 paint;
in vec4 glow;

out vec4 pixel;  // alpha: how much of it may bloom

vec3 outside(vec3 n, vec3 v) {
  vec3 skin = paint.rgb * (1.0 - 0.75 * glow.a);
  vec3 l = key_light.xyz;
  float height = clamp((at.y - ground.x) / max(grid.w, 1e-6), 0.0, 1.0);
  float open = 0.42 + 0.58 * smoothstep(0.0, 0.55, height + 0.5 * max(n.y, 0.0));
  vec3 sky = mix(kGroundLight * open, kSkyLight, 0.5 + 0.5 * n.y) * mix(open, 1.0, 0.5);
  float facing = max(dot(n, l), 0.0);
  vec3 diffuse = skin * (sky + facing * kKeyColour * 0.62);

  float gloss = paint.a * (1.0 - 0.8 * glow.a);
  float edge = 1.0 - clamp(dot(n, v), 0.0, 1.0);
  float fresnel = mix(0.035, 0.05, gloss) + (0.25 + 0.55 * gloss) * gloss * edge * edge * edge * edge;
  vec3 mirrored = surroundings(reflect(-v, n)) * fresnel * (0.25 + 1.9 * gloss) * open;
  float sharp = exp2(3.0 + 6.5 * gloss);
  float shine = pow(max(dot(n, normalize(l + v)), 0.0), sharp) * (sharp + 8.0) * 0.010 * gloss * step(0.0, dot(n, l));
  vec3 rim = kRimColour * edge * edge * edge * max(dot(n, normalize(kRimDirection)), 0.0) * (0.25 + 0.75 * gloss);
  return diffuse + mirrored + shine * kKeyColour + rim;
}

// The bare inside of a sheet.
vec3 inside(vec3 n) {
  vec3 sky = mix(kGroundLight, kSkyLight * 0.75, 0.5 + 0.5 * n.y);
  return vec3(0.088, 0.087, 0.088) * (sky + max(dot(n, key_light.xyz), 0.0) * kKeyColour * 0.25);
}

void main() {
  vec3 v = -normalize(at);
  vec3 n = normalize(gl_FrontFacing ? normal : -normal);
  vec3 bare = gl_FrontFacing ? outside(n, v) : inside(n);
  vec3 skin = gl_FrontFacing ? paint.rgb : vec3(0.06);
  vec3 colour = bare + (0.25 * skin + 0.05) * spot_light(at, n) + glow.rgb * (gl_FrontFacing ? 1.0 : 0.8);
  if (!gl_FrontFacing) colour *= heat.w;
#ifdef WIRE
  vec3 wide = fwidth(corner);
  vec3 line = smoothstep(vec3(0.0), wide * 1.15, corner);
  colour = mix(colour * 0.35 + vec3(0.20, 0.25, 0.31) * 0.55, colour, min(line.x, min(line.y, line.z)));
#endif
  float shining = max(glow.r - 0.55, 0.0);
  pixel = vec4(finish(haze(colour, at)), clamp(shining * 0.32, 0.0, 1.0));
}
