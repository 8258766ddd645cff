in vec2 uv;

uniform sampler2D picture;  // of the screen, with opacity

out vec4 pixel;

void main() { pixel = texture(picture, uv); }
