uniform vec4 ends;           // pixels: xy where the segment begins, zw where it ends
uniform vec4 depths;         // xy: depth of the focus over the depth at either end, zw: in the depth buffer
uniform vec4 share;          // in lengths from the emitter to the strike: xy at either end, z all of the beam, w its fade
uniform vec4 core;           // width in pixels at the focus, its least, its largest

uniform float strength;      // of the light, 1 for a beam that is on

out vec4 pixel;

void main() {
  vec2 way = ends.zw - ends.xy, from_begin = gl_FragCoord.xy - ends.xy;
  float t = clamp(dot(from_begin, way) / max(dot(way, way), 1e-6), 0.0, 1.0);
  float off = length(from_begin - way * t);
  float nearness = mix(depths.x, depths.y, t);
  gl_FragDepth = clamp(mix(depths.z, depths.w, t), 0.0, 1.0);  // the beam comes from before the near plane
  float along = mix(share.x * depths.x, share.y * depths.y, t) / nearness;

  float width = clamp(core.x * nearness, core.y, core.z);
  float thin = 1.0 - smoothstep(width * 0.5, width * 0.5 + 1.1, off);
  float halo = exp(-off * off / (width * width * 9.0)) * 0.30 + exp(-off / (width * 4.5)) * 0.12;
  halo *= 1.0 - smoothstep(0.75, 1.0, off / (core.z * 16.0));
  // A beam that comes from beside the eye is seen whole although most of the picture shows its beginning.
  float ends_in = smoothstep(0.0, 0.7, max(along, t));
  if (share.w > 0.0) ends_in *= 1.0 - smoothstep(share.z - share.w, share.z, along);
  vec3 colour = thin * vec3(1.0, 0.96, 0.90) + halo * vec3(1.0, 0.36, 0.12);
  ends_in *= strength;
  pixel = vec4(colour * ends_in, (thin * 0.5 + halo * 0.3) * ends_in);
}
