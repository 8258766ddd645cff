#include "ui/render/view/scalar_field.h"

#include <cmath>

#include "core/base/angle.h"
#include "ui/render/view/oklab.h"

namespace kerf {

// Cold colours, so that nobody takes a number for heat; lightness rises while the hue turns.
glm::dvec3 linear_scalar_colour(double t) {
  const auto path = [](double s) {
    return oklab_of(0.27 + 0.66 * s, 0.07 + 0.03 * std::sin(kPi * s), 305 - 197 * s);
  };
  return linear_along(path, t);
}

glm::vec3 scalar_colour(double t) { return glm::vec3(screen_from_linear(linear_scalar_colour(t))); }

}  // namespace kerf
