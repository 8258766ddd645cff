// A quad that faces the eye: a disc around a place, or a streak between two places, never thinner than two pixels.
layout(location = 0) in vec3 at;       // frame
layout(location = 1) in vec3 towards;  // frame: where the streak begins, `at` for a disc
layout(location = 2) in vec2 corner;   // -1 .. 1
layout(location = 3) in vec2 look_in;  // half the width in the frame's unit, heat or opacity

out vec2 across;
out float strength;

void main() {
  across = corner;
  strength = look_in.y;
  vec4 head = clip_from_frame * vec4(at, 1.0), tail = clip_from_frame * vec4(towards, 1.0);
  vec2 aspect = vec2(viewport.x * viewport.w, 1.0);
  vec2 along = (head.xy / max(head.w, 1e-6) - tail.xy / max(tail.w, 1e-6)) * aspect;
  along = dot(along, along) > 1e-12 ? normalize(along) : vec2(0.0, 1.0);
  // Half the width in clip coordinates, in orthographic views as in perspective ones.
  float scale = length(vec3(clip_from_frame[0].y, clip_from_frame[1].y, clip_from_frame[2].y));
  float width = max(look_in.x * scale, 1.5 * viewport.w * head.w);
  vec4 end = corner.y < 0.0 ? tail : head;
  vec2 side = vec2(-along.y, along.x) * corner.x + along * corner.y;
  gl_Position = end.w > 0.0 ? end + vec4(side * width / aspect, 0.0, 0.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
