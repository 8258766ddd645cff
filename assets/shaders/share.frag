// A share of another picture, pixel by pixel.
uniform sampler2D picture;
uniform vec4 place;  // xy: where the picture begins; z: the share

out vec4 pixel;

void main() { pixel = texelFetch(picture, ivec2(gl_FragCoord.xy - place.xy), 0) * place.z; }
