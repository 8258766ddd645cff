#pragma once

#include <glm/glm.hpp>

#include "ui/gl/buffers.h"
#include "ui/gl/program.h"
#include "ui/render/passes/surface_overlays.h"

namespace kerf {

// Returns the linear light emitted at a temperature [K], as by a camera exposed for the workshop: black
// below kGlowFrom, then the colour of a black body. Luminance spans eight decades from there to molten
// steel; its fourth root is used, so that one exposure shows all of them and the brightest tends to white
// as on film.
glm::vec3 shown_glow(double temperature);

// Returns the tint of a surface with this maximum temperature [K], in linear light, and its opacity: the
// colours of tempered steel from straw over brown to blue-grey, and dark scale after glowing.
glm::vec4 tint_of(double hottest);

// Returns a colour of the temperature view in sRGB, t = 0 .. 1 from the coldest to the hottest: from dark
// blue-violet over red and orange to pale yellow. Equal steps of t are equal steps in OKLab.
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

// The upper end of the scale of the temperature view [K]: the highest melting or decomposition temperature
// of the materials in the world.
double end_of_heat_scale(const World& world);

// Draws the scale from the ambient to `end` [K] over the bound framebuffer, at its lower left, with labels
// in kelvin. `height` is that of the frame in pixels. Precondition: `end` is above the ambient.
void draw_heat_bar(double end, FaceNumbers& numbers, int height);

}  // namespace kerf
