#pragma once

#include <string>

#include "core/cut/cut_step.h"

namespace kerf {

class Fields;

// Begins a stroke: the beam is on from here, at this pose (world coordinates), at time 0 of the stroke.
struct BeginStroke {
  CutSettings settings;
  Pose pose;

  static constexpr const char* kName = "begin";
  std::string words() const;
  size_t weight() const { return 0; }
};
void describe(Fields& f, BeginStroke& c);

}  // namespace kerf
