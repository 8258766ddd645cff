flat in vec4 mark;

out vec4 pixel;

void main() { pixel = mark; }
