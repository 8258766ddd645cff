out vec4 pixel;

void main() { pixel = vec4(background(sight()), 0.0); }
