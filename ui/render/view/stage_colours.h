#pragma once

#include <glm/vec4.hpp>

namespace kerf {

// The colours of the surroundings of a scene in linear light, a part of the uniform block "Frame"; frame.glsl
// documents its members. They are uniforms because a software renderer would compute them anew for every
// pixel.
struct StageColours {
  glm::vec4 sky_high{0}, sky_low{0}, sky_band{0};
  glm::vec4 sky_light{0}, ground_light{0};
  glm::vec4 ground_matt{0}, ground_line{0};
};

// Those of a workshop at dusk, or by day.
const StageColours& stage_colours(bool by_day);

}  // namespace kerf
