uniform float opacity;

out vec4 pixel;

// The transparent black that the paper lays over what is in shadow.
void main() { pixel = vec4(0.0, 0.0, 0.0, opacity); }
