#pragma once

#include <optional>

#include "core/base/vec3.h"
#include "ui/editor/material/met_sheet.h"
#include "ui/editor/shared/workspace.h"

namespace kerf {

// How fast the pointer moves over the screen, evened out over a fifth of a second.
class PointerSpeed {
 public:
  // To be called once a frame; `seconds` have passed since the last call.
  void follow(const Vec2& pointer, double seconds);
  double pixels_per_second() const { return speed_; }

 private:
  std::optional<Vec2> last_;
  double speed_ = 0;
};

// What the pointer is over.
struct PointerAim {
  MetSheet met;
  double speed = 0;  // m/s, with which the pointer goes over it; 0 where it rests
};

// Nothing where the pointer is over no body. O(log faces).
std::optional<PointerAim> aim_of(const Workspace& on, const PointerSpeed& pointer);

}  // namespace kerf
