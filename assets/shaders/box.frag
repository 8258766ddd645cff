flat in vec4 colour;
flat in float dotted;
noperspective in float along;

out vec4 pixel;

void main() {
  if (dotted > 0.5 && fract(along / 5.0) > 0.5) discard;
  pixel = colour;
}
