#pragma once

#include "core/base/pose.h"

namespace kerf {

// Where the beam of a stroke is, and when.
struct BeamAt {
  Pose pose;
  double time = 0;  // s since the stroke began
};

}  // namespace kerf
