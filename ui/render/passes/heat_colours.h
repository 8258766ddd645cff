#pragma once

#include <glm/glm.hpp>

#include "ui/gl/buffers.h"
#include "ui/gl/program.h"
#include "ui/render/passes/face_numbers.h"

namespace kerf {

// Linear light of what glows at a temperature (K), as bright as a camera shows it that is exposed for the
// workshop: nothing below kGlowFrom, then the colour of a black body. Luminance spans eight
// decades from there to molten steel; here its fourth root, so that one exposure shows all of them, and what
// is brightest runs to white as it does on film.
glm::vec3 shown_glow(double temperature);

// The tint of a surface that was as hot as this (K), in linear light, and its opacity: the colours of
// tempered steel from straw over brown to blue-grey, and dark scale where it glowed.
glm::vec4 tint_of(double hottest);

// A colour of the temperature view in sRGB, t = 0 .. 1 from the coldest to the hottest: from dark blue-violet
// over red and orange to pale yellow. Equal steps of t are equal steps in OKLab.
glm::vec3 heat_colour(double t);

// Glow, tint, colours of the temperature view and of scalar fields as the rows of a texture for body.frag.
class HeatRamps {
 public:
  HeatRamps();
  // Binds the texture for a program that is in use.
  void bind(const gl::Program& program) const;

 private:
  gl::Texture table_;
};

// The temperature at which the scale of the temperature view ends (K): the highest at which a material of the
// world melts or decomposes.
double end_of_heat_scale(const World& world);

// Draws the scale from the ambient to `end` (K) over the bound picture, at its lower left, with numbers in
// kelvin beside it. `height` is that of the picture in pixels. Precondition: `end` is above the ambient.
void draw_heat_bar(double end, FaceNumbers& numbers, int height);

}  // namespace kerf
