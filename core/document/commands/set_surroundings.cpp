#include "core/document/commands/set_surroundings.h"

#include "core/document/text/fields.h"

namespace kerf {

std::string SetSurroundings::words() const { return "Gravity and ground"; }

void describe(Fields& f, SetSurroundings& c) {
  f.vector("gravity", c.around.gravity);
  f.number("ground", c.around.ground, kFinite);
  f.number("metre", c.around.metre, kPositive, 1);
}

Result<Delta> SetSurroundings::run(World& world, uint32_t, const Progress*) const {
  Delta delta;
  if (world.surroundings() == around) return delta;
  world.set_surroundings(around);
  delta.surroundings = true;
  return delta;
}

}  // namespace kerf
