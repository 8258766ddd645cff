#pragma once

#include <string>
#include <variant>

#include "core/cut/cut_step.h"

namespace kerf {

// Everything that changes the world is one of these. A stroke is its beginning, poses in world coordinates
// and its end, never pixels, so the journal of commands gives the same world wherever it is replayed.
struct BeginStroke {
  CutSettings settings;
  Pose pose;  // unit direction
};
struct MoveStroke {
  Pose pose;  // unit direction, not opposite to the last one
};
struct EndStroke {};

using Command = std::variant<BeginStroke, MoveStroke, EndStroke>;

}  // namespace kerf
