#pragma once

#include <string>

#include "core/cut/cut_step.h"

namespace kerf {

class Fields;

// Takes the last stroke back and cuts it again with other settings.
struct Recut {
  CutSettings settings;

  static constexpr const char* kName = "recut";
  std::string words() const;
  size_t weight() const { return 0; }
};
void describe(Fields& f, Recut& c);

}  // namespace kerf
