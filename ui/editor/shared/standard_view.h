#pragma once

#include <array>
#include <optional>

#include "ui/render/view/camera.h"

namespace kerf {

// A view along an axis of the world, as on a technical drawing.
struct StandardView {
  const char* name;
  double yaw, pitch;  // of the eye, see Camera::turn_to
};

// In pairs that look at each other.
inline constexpr double kQuarterTurn = 1.5707963267948966;
inline constexpr std::array kStandardViews{
    StandardView{"Front", 0, 0},
    StandardView{"Back", 2 * kQuarterTurn, 0},
    StandardView{"Right", kQuarterTurn, 0},
    StandardView{"Left", -kQuarterTurn, 0},
    StandardView{"Top", 0, kQuarterTurn},
    StandardView{"Bottom", 0, -kQuarterTurn},
};

// The standard view that the camera shows or moves to, if it is one.
std::optional<StandardView> standard_view_of(const Camera& camera);

}  // namespace kerf
