in float height;
flat in vec3 colour;
out vec4 pixel;

void main() { pixel = vec4(colour, 1.0) * (1.0 - smoothstep(0.0, 0.75, height)); }
