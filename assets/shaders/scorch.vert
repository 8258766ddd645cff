// A burnt place, a quad on a surface.
layout(location = 0) in vec3 at;      // frame
layout(location = 2) in vec2 corner;  // -1 .. 1
layout(location = 3) in vec2 look;    // y: heat

out vec2 across;
out float heat;

void main() {
  across = corner;
  heat = look.y;
  gl_Position = clip_from_frame * vec4(at, 1.0);
}
