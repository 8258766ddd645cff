in float height;
out vec4 pixel;

void main() { pixel = vec4(1.0 - smoothstep(0.0, 0.75, height)); }
