#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

class Fields;

// Sets gravity and the ground.
struct SetSurroundings {
  Surroundings around;

  static constexpr const char* kName = "surroundings";
  std::string words() const;
  size_t weight() const { return 0; }
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SetSurroundings& c);

}  // namespace kerf
