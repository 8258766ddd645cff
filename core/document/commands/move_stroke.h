#pragma once

#include <string>

#include "core/base/pose.h"

namespace kerf {

class Fields;

// Moves the beam of the running stroke on, with the beam on all the way.
struct MoveStroke {
  Pose pose;        // world coordinates; the direction is not opposite to the one before
  double time = 0;  // s since the stroke began, not before the pose before; all 0 where times are not known

  static constexpr const char* kName = "move";
  std::string words() const;
  size_t weight() const { return 0; }
};
void describe(Fields& f, MoveStroke& c);

}  // namespace kerf
