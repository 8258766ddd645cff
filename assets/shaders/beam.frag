noperspective in float across;
in float along;

uniform float core;  // pixels

out vec4 pixel;

void main() {
  float off = abs(across);
  float thin = 1.0 - smoothstep(core * 0.5, core * 0.5 + 1.1, off);
  float halo = exp(-off * off / (core * core * 9.0)) * 0.30 + exp(-off / (core * 4.5)) * 0.12;
  float ends = smoothstep(0.0, 0.7, along);
  vec3 colour = thin * vec3(1.0, 0.86, 0.70) + halo * vec3(1.0, 0.40, 0.16);
  pixel = vec4(colour * ends, (thin * 0.5 + halo * 0.3) * ends);
}
