layout(location = 0) in vec3 from;  // one line an instance, in the body's float frame
layout(location = 1) in vec3 to;
#ifdef PLACED
layout(location = 2) in float group;  // of the face, see placed.glsl
#else
uniform mat4 frame_from_body;
#endif

uniform float half_width;
uniform vec4 hit_colour;
uniform float pulled;  // towards the eye, in frame units, so that lines below a surface show

flat out vec4 colour;
flat out float dotted;
noperspective out float along;

vec3 pull(vec3 at) {
  vec3 way = at + camera_forward.xyz * camera_forward.w;
  float far = max(length(way), 1e-6);
  return at - way * (min(pulled, 0.5 * far) / far);
}

void main() {
#ifdef PLACED
  vec4 look = look_of(uint(group)), turn = turn_of(uint(group));
  vec3 a = placed(from, look, turn), b = placed(to, look, turn);
#else
  vec3 a = (frame_from_body * vec4(from, 1.0)).xyz;
  vec3 b = (frame_from_body * vec4(to, 1.0)).xyz;
#endif
  gl_ClipDistance[0] = dot(section, vec4(a, 1.0));
  gl_Position = line_vertex(pull(a), pull(b), gl_VertexID, half_width, along);
#ifdef PLACED
  if (look.w < 0.0) gl_Position = kNowhere;
#endif
  colour = hit_colour;
  dotted = 0.0;
}
