// From linear light to the eight bits of the screen.
#ifdef SAMPLES
uniform sampler2DMS scene;
uniform int which;  // index of the sample
#else
uniform sampler2D scene;
const int which = 0;
#endif

out vec4 pixel;

void main() {
  vec4 seen = texelFetch(scene, ivec2(gl_FragCoord.xy), which);
  pixel = vec4(finish(seen.rgb), seen.a);
}
