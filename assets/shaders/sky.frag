out vec4 pixel;

void main() { pixel = vec4(background(rise_of_sight()), 0.0); }
